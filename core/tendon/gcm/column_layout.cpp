#include <tendon/gcm/column_layout.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace tendon::graph {
namespace {

constexpr int kSweeps = 4;
constexpr double kTallness = 6;  // rows per column of the blocks without peers

/// An interval of a column.
struct Interval {
  double top;
  double bottom;
};

/// The occupied intervals of a column, from top to bottom, without overlap.
class Column {
 public:
  void Take(const Interval& interval) {
    const auto place =
        std::lower_bound(taken_.begin(), taken_.end(), interval.top,
                         [](const Interval& other, double top) { return other.top < top; });
    taken_.insert(place, interval);
  }

  [[nodiscard]] bool empty() const { return taken_.empty(); }
  [[nodiscard]] double bottom() const { return taken_.empty() ? 0 : taken_.back().bottom; }

  /// Returns the y of the free interval of this height that is nearest to `wanted`. Linear in the
  /// number of occupied intervals.
  [[nodiscard]] double NearestFree(double wanted, double height, double gap) const {
    double best = -1;
    const auto offer = [&](double y) {
      const bool is_nearer = best < 0 || std::abs(y - wanted) < std::abs(best - wanted);
      if (is_nearer && IsFree(y, height, gap)) best = y;
    };
    offer(std::max(0.0, wanted));
    if (best >= 0) return best;
    offer(0);
    for (const Interval& taken : taken_) {
      offer(taken.top - gap - height);
      offer(taken.bottom + gap);
    }
    return best;
  }

 private:
  [[nodiscard]] bool IsFree(double y, double height, double gap) const {
    const auto next = std::upper_bound(
        taken_.begin(), taken_.end(), y,
        [gap](double from, const Interval& other) { return from < other.bottom + gap; });
    return y >= 0 && (next == taken_.end() || next->top >= y + height + gap);
  }

  std::vector<Interval> taken_;
};

enum class Visit { kNew, kOpen, kDone };

/// A depth-first search without recursion. It visits the providers of a node before the node.
class LongestPaths {
 public:
  LongestPaths(std::size_t count, const std::vector<LayerEdge>& edges)
      : providers_(count), visits_(count, Visit::kNew), layers_(count, 0) {
    for (const auto& edge : edges) providers_[edge.to].push_back(edge.from);
  }

  std::vector<int> Compute() && {
    for (std::size_t start = 0; start < providers_.size(); ++start) {
      if (visits_[start] == Visit::kNew) Descend(start);
    }
    return std::move(layers_);
  }

 private:
  void Descend(std::size_t start) {
    std::vector<std::size_t> stack{start};
    while (!stack.empty()) {
      const std::size_t here = stack.back();
      if (visits_[here] == Visit::kNew) {
        visits_[here] = Visit::kOpen;
        for (const std::size_t provider : providers_[here]) {
          if (visits_[provider] == Visit::kNew) stack.push_back(provider);
        }
        continue;
      }
      stack.pop_back();
      if (visits_[here] == Visit::kDone) continue;
      visits_[here] = Visit::kDone;
      for (const std::size_t provider : providers_[here]) {
        // An edge to a provider that is not done yet closes a cycle, so it is ignored.
        if (visits_[provider] != Visit::kDone || provider == here) continue;
        layers_[here] = std::max(layers_[here], layers_[provider] + 1);
      }
    }
  }

  std::vector<std::vector<std::size_t>> providers_;
  std::vector<Visit> visits_;
  std::vector<int> layers_;
};

}  // namespace

struct ColumnLayout::Plan {
  const std::vector<Block>& blocks;
  std::vector<std::vector<std::size_t>> peers;
  std::vector<int> layers;  // -1 for blocks without peers
  std::vector<std::optional<Place>> places;
  int column_count = 1;
  std::vector<Column> columns{};

  void Put(std::size_t block, const Place& place) {
    places[block] = place;
    column_count = std::max(column_count, place.column + 1);
    ColumnAt(place.column).Take({place.y, place.y + place.height});
  }

  Column& ColumnAt(int column) {
    const auto index = static_cast<std::size_t>(column);
    if (index >= columns.size()) columns.resize(index + 1);
    return columns[index];
  }

  /// Returns the mean y of the centres of the peers that are already placed; empty if no peer is
  /// placed.
  [[nodiscard]] std::optional<double> PeersMiddle(std::size_t block) const {
    double sum = 0;
    int count = 0;
    for (const std::size_t peer : peers[block]) {
      if (!places[peer]) continue;
      sum += places[peer]->y + places[peer]->height / 2;
      ++count;
    }
    return count == 0 ? std::nullopt : std::optional(sum / count);
  }
};

ColumnLayout::Plan ColumnLayout::PlanFor(const std::vector<Block>& blocks,
                                         const std::vector<LayerEdge>& edges) const {
  Plan plan{blocks, std::vector<std::vector<std::size_t>>(blocks.size()),
            LayersOf(blocks.size(), edges), std::vector<std::optional<Place>>(blocks.size())};
  for (const auto& edge : edges) {
    plan.peers[edge.from].push_back(edge.to);
    plan.peers[edge.to].push_back(edge.from);
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    plan.column_count = std::max(plan.column_count, plan.layers[i] + 1);
    if (plan.peers[i].empty()) plan.layers[i] = -1;
  }
  return plan;
}

bool ColumnLayout::Arrange(std::vector<Block> blocks, std::vector<LayerEdge> edges) {
  if (blocks == blocks_ && edges == edges_) return false;
  blocks_ = std::move(blocks);
  edges_ = std::move(edges);
  Plan plan = PlanFor(blocks_, edges_);
  KeepPlaces(plan);
  PlaceLayered(plan);
  PlaceLoose(plan);
  Commit(plan);
  return true;
}

void ColumnLayout::KeepPlaces(Plan& plan) const {
  const auto name_of = [&](std::size_t i) { return std::pair(plan.blocks[i].key, plan.layers[i]); };
  const auto place_of = [&](std::size_t i) { return places_.at(name_of(i)); };
  Order known;
  for (std::size_t i = 0; i < plan.blocks.size(); ++i) {
    if (plan.blocks[i].keeps_place && places_.contains(name_of(i))) known.push_back(i);
  }
  std::stable_sort(known.begin(), known.end(),
                   [&](auto a, auto b) { return place_of(a).y < place_of(b).y; });
  for (const std::size_t i : known) {
    Place place = place_of(i);
    place.height = plan.blocks[i].size.height;
    // If a block above has grown, this block moves down by as much as necessary.
    const Column& column = plan.ColumnAt(place.column);
    if (!column.empty()) place.y = std::max(place.y, column.bottom() + spacing_.rows);
    plan.Put(i, place);
  }
}

void ColumnLayout::PlaceLayered(Plan& plan) const {
  Order order;
  for (std::size_t i = 0; i < plan.blocks.size(); ++i) {
    if (!plan.places[i] && plan.layers[i] >= 0) order.push_back(i);
  }
  // Repeatedly replaces the rank of each block by the mean rank of its peers, so that connected
  // blocks come near to each other.
  std::vector<double> rank(plan.blocks.size());
  std::iota(rank.begin(), rank.end(), 0.0);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    std::vector<double> next = rank;
    for (const std::size_t i : order) {
      double sum = 0;
      for (const std::size_t peer : plan.peers[i]) sum += rank[peer];
      next[i] = sum / static_cast<double>(plan.peers[i].size()) + rank[i] * 1e-3;
    }
    rank = next;
  }
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
    return std::pair(plan.layers[a], rank[a]) < std::pair(plan.layers[b], rank[b]);
  });
  for (const std::size_t i : order) {
    const double height = plan.blocks[i].size.height;
    const auto middle = plan.PeersMiddle(i);
    const double wanted = middle ? *middle - height / 2 : 0;
    const int column = plan.layers[i];
    const double y = plan.ColumnAt(column).NearestFree(wanted, height, spacing_.rows);
    plan.Put(i, Place{plan.layers[i], column, y, height});
  }
}

void ColumnLayout::PlaceLoose(Plan& plan) const {
  const auto loose = std::count(plan.layers.begin(), plan.layers.end(), -1);
  // If there are only a few blocks without peers, they get no additional columns. They are put
  // below the other blocks of a column, where no edge passes behind them.
  const int columns =
      std::max(plan.column_count,
               static_cast<int>(std::ceil(std::sqrt(static_cast<double>(loose) / kTallness))));
  Order order;
  for (std::size_t i = 0; i < plan.blocks.size(); ++i) {
    if (!plan.places[i]) order.push_back(i);
  }
  std::stable_partition(order.begin(), order.end(),
                        [&](std::size_t i) { return plan.blocks[i].keeps_place; });
  for (const std::size_t i : order) {
    int column = 0;
    for (int other = 1; other < columns; ++other) {
      if (plan.ColumnAt(other).bottom() < plan.ColumnAt(column).bottom()) column = other;
    }
    const double bottom = plan.ColumnAt(column).bottom();
    const double y = bottom == 0 ? 0 : bottom + spacing_.rows;
    plan.Put(i, Place{-1, column, y, plan.blocks[i].size.height});
  }
}

void ColumnLayout::Commit(const Plan& plan) {
  std::vector<double> widths(static_cast<std::size_t>(plan.column_count), 0);
  for (std::size_t i = 0; i < plan.blocks.size(); ++i) {
    double& width = widths[static_cast<std::size_t>(plan.places[i]->column)];
    width = std::max(width, plan.blocks[i].size.width);
  }
  std::vector<double> lefts;
  double left = 0;
  for (const double width : widths) {
    lefts.push_back(left);
    if (width > 0) left += width + spacing_.columns;
  }
  rects_.clear();
  size_ = {};
  for (std::size_t i = 0; i < plan.blocks.size(); ++i) {
    const Place& place = *plan.places[i];
    const auto column = static_cast<std::size_t>(place.column);
    if (plan.blocks[i].keeps_place) places_[{plan.blocks[i].key, place.layer}] = place;
    rects_[plan.blocks[i].key] = {lefts[column], place.y, widths[column], place.height};
    size_.width = std::max(size_.width, lefts[column] + widths[column]);
    size_.height = std::max(size_.height, place.y + place.height);
  }
}

Rect ColumnLayout::rect(const std::string& key) const {
  const auto found = rects_.find(key);
  return found == rects_.end() ? Rect() : found->second;
}

std::vector<int> LayersOf(std::size_t count, const std::vector<LayerEdge>& edges) {
  return LongestPaths(count, edges).Compute();
}

}  // namespace tendon::graph
