#include <gcm_gui/graph/layout/graph_layout.h>
#include <gcm_gui/graph/layout/node_metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QFontMetricsF>
#include <algorithm>
#include <set>
#include <utility>

namespace tendon::gui {
namespace {

constexpr ColumnLayout::Spacing kNodeSpacing{56, 12};
constexpr ColumnLayout::Spacing kProcessSpacing{48, 16};
constexpr QSizeF kEmptyProcess{128, 24};
constexpr double kTitleSlack = 96;  // for " · lost 12 min"

QString ProcessOf(const QString& path) { return path.section('/', 0, 0); }

using Indices = QHash<QString, std::size_t>;

Indices IndicesOf(const std::vector<ColumnLayout::Block>& blocks) {
  Indices indices;
  for (std::size_t i = 0; i < blocks.size(); ++i) indices.insert(blocks[i].key, i);
  return indices;
}

/// From thing to thing, each once, none from one to itself.
class EdgeCollector {
 public:
  void Add(const Indices& indices, const QString& provider, const QString& client) {
    const auto from = indices.constFind(provider);
    const auto to = indices.constFind(client);
    if (from == indices.constEnd() || to == indices.constEnd() || *from == *to) return;
    edges_.insert({*from, *to});
  }

  [[nodiscard]] std::vector<LayerEdge> Take() const {
    std::vector<LayerEdge> edges;
    for (const auto& [from, to] : edges_) edges.push_back({from, to});
    return edges;
  }

 private:
  std::set<std::pair<std::size_t, std::size_t>> edges_;
};

}  // namespace

GraphLayout::GraphLayout() : processes_(kProcessSpacing) {}

void GraphLayout::takeAffinities(const std::vector<Affinity>& affinities) {
  if (affinities == affinities_) return;
  affinities_ = affinities;
  inside_.clear();
  across_.clear();
  for (const Affinity& affinity : affinities_) {
    const QString provider = ProcessOf(affinity.provider);
    const QString client = ProcessOf(affinity.client);
    if (provider == client) {
      inside_[provider].push_back(affinity);
    } else {
      across_.push_back({provider, client});
    }
  }
}

bool GraphLayout::arrangeNodes(const ProcessPicture& process) {
  std::vector<ColumnLayout::Block> blocks;
  for (const auto& node : process.nodes) blocks.push_back({node.path, node.size, true});
  const Indices indices = IndicesOf(blocks);
  EdgeCollector edges;
  for (const Affinity& affinity : inside_[process.name]) {
    edges.Add(indices, affinity.provider, affinity.client);
  }
  ColumnLayout& inside = insides_.try_emplace(process.name, kNodeSpacing).first->second;
  return inside.arrange(std::move(blocks), edges.Take());
}

bool GraphLayout::update(const GraphPicture& picture) {
  takeAffinities(picture.affinities);
  const QFontMetricsF strong(Theme::instance().strong());
  std::vector<ColumnLayout::Block> blocks;
  bool moved = false;
  for (const auto& process : picture.processes) {
    if (arrangeNodes(process)) moved = true;
    QSizeF size = process.nodes.empty() ? kEmptyProcess : insides_.at(process.name).size();
    size.rwidth() = std::max(size.width(), strong.horizontalAdvance(process.name) + kTitleSlack);
    size += QSizeF(2 * kProcessInset, kProcessHead + kProcessInset);
    blocks.push_back({process.name, size, !process.nodes.empty()});
  }
  const Indices indices = IndicesOf(blocks);
  EdgeCollector edges;
  for (const Affinity& affinity : across_) edges.Add(indices, affinity.provider, affinity.client);
  if (processes_.arrange(std::move(blocks), edges.Take())) moved = true;
  if (moved) placeNodes(picture);
  return moved;
}

void GraphLayout::placeNodes(const GraphPicture& picture) {
  nodes_.clear();
  for (const auto& process : picture.processes) {
    const QPointF origin =
        processes_.rect(process.name).topLeft() + QPointF(kProcessInset, kProcessHead);
    const ColumnLayout& inside = insides_.at(process.name);
    for (const auto& node : process.nodes) {
      nodes_.insert(node.path, inside.rect(node.path).translated(origin));
    }
  }
}

}  // namespace tendon::gui
