#include <gcm_gui/graph/layout/graph_layout.h>
#include <gcm_gui/graph/layout/node_metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QFontMetricsF>
#include <algorithm>
#include <set>

namespace tendon::gui {
namespace {

constexpr ColumnLayout::Spacing kNodeSpacing{56, 12};
constexpr ColumnLayout::Spacing kProcessSpacing{48, 16};
constexpr QSizeF kEmptyProcess{128, 24};
constexpr double kTitleSlack = 96;  // for " · lost 12 min"

QString ProcessOf(const QString& path) { return path.section('/', 0, 0); }

/// The affinities between things by index, each once, none with itself.
template <typename KeyOf>
std::vector<LayerEdge> EdgesAmong(const std::vector<ColumnLayout::Block>& blocks,
                                  const std::vector<Affinity>& affinities, KeyOf key_of) {
  QHash<QString, std::size_t> index;
  for (std::size_t i = 0; i < blocks.size(); ++i) index.insert(blocks[i].key, i);
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& affinity : affinities) {
    const auto from = index.constFind(key_of(affinity.provider));
    const auto to = index.constFind(key_of(affinity.client));
    if (from == index.constEnd() || to == index.constEnd() || *from == *to) continue;
    edges.insert({*from, *to});
  }
  std::vector<LayerEdge> result;
  for (const auto& [from, to] : edges) result.push_back({from, to});
  return result;
}

}  // namespace

GraphLayout::GraphLayout() : processes_(kProcessSpacing) {}

void GraphLayout::arrangeNodes(const ProcessPicture& process,
                               const std::vector<Affinity>& affinities) {
  std::vector<ColumnLayout::Block> blocks;
  for (const auto& node : process.nodes) blocks.push_back({node.path, SizeOf(node), true});
  ColumnLayout& inside = insides_.try_emplace(process.name, kNodeSpacing).first->second;
  inside.arrange(blocks, EdgesAmong(blocks, affinities, [](const QString& path) { return path; }));
}

void GraphLayout::update(const GraphPicture& picture) {
  const QFontMetricsF strong(Theme::instance().strong());
  std::vector<ColumnLayout::Block> blocks;
  for (const auto& process : picture.processes) {
    arrangeNodes(process, picture.affinities);
    QSizeF size = process.nodes.empty() ? kEmptyProcess : insides_.at(process.name).size();
    size.rwidth() = std::max(size.width(), strong.horizontalAdvance(process.name) + kTitleSlack);
    size += QSizeF(2 * kProcessInset, kProcessHead + kProcessInset);
    blocks.push_back({process.name, size, !process.nodes.empty()});
  }
  processes_.arrange(blocks, EdgesAmong(blocks, picture.affinities, ProcessOf));
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
