#include <gcm_gui/graph/layout/graph_layout.h>

#include <gcm_gui/graph/layout/node_metrics.h>

#include <QRectF>
#include <QSizeF>
#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tendon::gui {
namespace {

using graph::ColumnLayout;
using graph::LayerEdge;

constexpr ColumnLayout::Spacing kNodeSpacing{56, 12};
constexpr ColumnLayout::Spacing kProcessSpacing{48, 16};
constexpr graph::Size kEmptyProcess{128, 24};

QString ProcessNameOf(const QString& path) { return path.section('/', 0, 0); }

QRectF RectOf(const graph::Rect& rect) { return {rect.x, rect.y, rect.width, rect.height}; }

using Indices = std::map<std::string, std::size_t>;

Indices IndicesOf(const std::vector<ColumnLayout::Block>& blocks) {
  Indices indices;
  for (std::size_t i = 0; i < blocks.size(); ++i) indices.emplace(blocks[i].key, i);
  return indices;
}

/// Collects edges, without duplicates and without edges from a node to itself.
class EdgeCollector {
 public:
  void Add(const Indices& indices, const QString& provider, const QString& client) {
    const auto from = indices.find(provider.toStdString());
    const auto to = indices.find(client.toStdString());
    if (from == indices.end() || to == indices.end() || from == to) return;
    edges_.insert({from->second, to->second});
  }

  [[nodiscard]] std::vector<LayerEdge> Take() const {
    std::vector<LayerEdge> edges;
    for (const auto& [from, to] : edges_) edges.push_back({from, to});
    return edges;
  }

 private:
  std::set<std::pair<std::size_t, std::size_t>> edges_;
};

/// Keeps a list of occupied rectangles, and finds free places beside them.
class FreeSpace {
 public:
  /// Keeps a gap of `between` around each rectangle.
  explicit FreeSpace(const QSizeF& between) : between_(between) {}

  void Take(const QRectF& rect) { taken_.push_back(rect); }
  /// Moves `wanted` to the right or downwards, past one occupied rectangle after another, until it
  /// overlaps none. Each step visits all occupied rectangles.
  [[nodiscard]] QRectF Beside(QRectF wanted) const;

 private:
  [[nodiscard]] const QRectF* InTheWayOf(const QRectF& rect) const;

  QSizeF between_;
  std::vector<QRectF> taken_;
};

const QRectF* FreeSpace::InTheWayOf(const QRectF& rect) const {
  for (const QRectF& taken : taken_) {
    if (taken.intersects(rect)) return &taken;
  }
  return nullptr;
}

QRectF FreeSpace::Beside(QRectF wanted) const {
  // The loop ends, because each step moves the rectangle to the right or downwards, past one
  // obstacle.
  while (const QRectF* obstacle = InTheWayOf(wanted)) {
    const double right = obstacle->right() + between_.width() - wanted.left();
    const double down = obstacle->bottom() + between_.height() - wanted.top();
    right < down ? wanted.translate(right, 0) : wanted.translate(0, down);
  }
  return wanted;
}

}  // namespace

GraphLayout::GraphLayout() : processes_(kProcessSpacing) {}

void GraphLayout::takeAffinities(const std::vector<Affinity>& affinities) {
  if (affinities == affinities_) return;
  affinities_ = affinities;
  inside_.clear();
  across_.clear();
  for (const Affinity& affinity : affinities_) {
    const QString provider = ProcessNameOf(affinity.provider);
    const QString client = ProcessNameOf(affinity.client);
    if (provider == client) {
      inside_[provider].push_back(affinity);
    } else {
      across_.push_back({provider, client});
    }
  }
}

bool GraphLayout::arrangeNodes(const ProcessPicture& process) {
  std::vector<ColumnLayout::Block> blocks;
  for (const auto& node : process.nodes) {
    blocks.push_back({node.path.toStdString(), {node.size.width(), node.size.height()}, true});
  }
  const Indices indices = IndicesOf(blocks);
  EdgeCollector edges;
  for (const Affinity& affinity : inside_[process.name]) {
    edges.Add(indices, affinity.provider, affinity.client);
  }
  ColumnLayout& inside = insides_.try_emplace(process.name, kNodeSpacing).first->second;
  return inside.Arrange(std::move(blocks), edges.Take());
}

bool GraphLayout::update(const GraphPicture& picture) {
  takeAffinities(picture.affinities);
  std::vector<ColumnLayout::Block> blocks;
  bool moved = std::exchange(other_places_, false);
  for (const auto& process : picture.processes) {
    if (arrangeNodes(process)) moved = true;
    graph::Size size = process.nodes.empty() ? kEmptyProcess : insides_.at(process.name).size();
    size.width = std::max(size.width, process.title_width);
    size.width += 2 * kProcessInset;
    size.height += kProcessHead + kProcessInset;
    blocks.push_back({process.name.toStdString(), size, !process.nodes.empty()});
  }
  const Indices indices = IndicesOf(blocks);
  EdgeCollector edges;
  for (const Affinity& affinity : across_) edges.Add(indices, affinity.provider, affinity.client);
  if (processes_.Arrange(std::move(blocks), edges.Take())) moved = true;
  if (moved) placeAll(picture);
  return moved;
}

void GraphLayout::setPlaces(std::map<QString, QPointF> places) {
  if (places == places_) return;
  places_ = std::move(places);
  other_places_ = true;
}

QRectF GraphLayout::columnRect(const QString& process) const {
  return RectOf(processes_.rect(process.toStdString()));
}

bool GraphLayout::hasPlaced(const ProcessPicture& process) const {
  if (places_.empty()) return false;
  return std::any_of(process.nodes.begin(), process.nodes.end(),
                     [this](const NodePicture& node) { return places_.contains(node.path); });
}

void GraphLayout::placeNodes(const ProcessPicture& process, const QRectF& box) {
  const QPointF origin = box.topLeft() + QPointF(kProcessInset, kProcessHead);
  const ColumnLayout& inside = insides_.at(process.name);
  for (const auto& node : process.nodes) {
    arrangement_.nodes.insert(node.path,
                              RectOf(inside.rect(node.path.toStdString())).translated(origin));
  }
}

QRectF GraphLayout::placeByHand(const ProcessPicture& process) {
  placeNodes(process, columnRect(process.name));
  FreeSpace room({kNodeSpacing.columns, kNodeSpacing.rows});
  QRectF all;
  const auto put = [&](const QString& path, const QRectF& rect) {
    arrangement_.nodes.insert(path, rect);
    room.Take(rect);
    all |= rect;
  };
  for (const auto& node : process.nodes) {
    const auto place = places_.find(node.path);
    if (place == places_.end()) continue;
    put(node.path, {place->second, arrangement_.nodes.value(node.path).size()});
  }
  for (const auto& node : process.nodes) {
    if (places_.contains(node.path)) continue;
    put(node.path, room.Beside(arrangement_.nodes.value(node.path)));
  }
  all.setWidth(std::max(all.width(), process.title_width));
  return all.adjusted(-kProcessInset, -kProcessHead, kProcessInset, kProcessInset);
}

void GraphLayout::placeAll(const GraphPicture& picture) {
  arrangement_.boxes.clear();
  arrangement_.nodes.clear();
  FreeSpace room({kProcessSpacing.columns, kProcessSpacing.rows});
  bool any_by_hand = false;
  std::vector<const ProcessPicture*> others;
  for (const auto& process : picture.processes) {
    if (!hasPlaced(process)) {
      others.push_back(&process);
      continue;
    }
    any_by_hand = true;
    const QRectF box = placeByHand(process);
    arrangement_.boxes.insert(process.name, box);
    room.Take(box);
  }
  for (const ProcessPicture* process : others) {
    QRectF box = columnRect(process->name);
    if (any_by_hand) room.Take(box = room.Beside(box));
    arrangement_.boxes.insert(process->name, box);
    placeNodes(*process, box);
  }
}

}  // namespace tendon::gui
