#include <tendon/gcm/graph/column_layout.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace tendon::graph {
namespace {

constexpr int kSweeps = 4;
constexpr double kTallness = 6;  // of a field of loose ones: rows for each column

/// Where something of `height` can stand in a column.
struct Interval {
  double top;
  double bottom;
};

bool IsFree(const std::vector<Interval>& taken, double y, double height, double gap) {
  return y >= 0 && std::none_of(taken.begin(), taken.end(), [&](const Interval& t) {
           return y < t.bottom + gap && t.top < y + height + gap;
         });
}

double NearestFree(const std::vector<Interval>& taken, double wanted, double height, double gap) {
  std::vector<double> candidates{std::max(0.0, wanted), 0.0};
  for (const Interval& t : taken) {
    candidates.push_back(t.bottom + gap);
    candidates.push_back(t.top - gap - height);
  }
  double best = -1;
  for (const double y : candidates) {
    if (!IsFree(taken, y, height, gap)) continue;
    if (best < 0 || std::abs(y - wanted) < std::abs(best - wanted)) best = y;
  }
  return best;
}

}  // namespace

struct ColumnLayout::Plan {
  const std::vector<Block>& blocks;
  std::vector<std::vector<std::size_t>> peers;
  std::vector<int> layers;  // -1 for loose ones
  std::vector<std::optional<Place>> places;
  int column_count = 1;

  [[nodiscard]] std::vector<Interval> Taken(int column) const {
    std::vector<Interval> taken;
    for (const auto& place : places) {
      if (place && place->column == column) taken.push_back({place->y, place->y + place->height});
    }
    return taken;
  }

  [[nodiscard]] double Bottom(int column) const {
    double bottom = 0;
    for (const Interval& interval : Taken(column)) bottom = std::max(bottom, interval.bottom);
    return bottom;
  }

  /// The middle of those peers that have a place already; nothing when none has.
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
    // One above that has grown pushes it down, no further than it must.
    for (const Interval& above : plan.Taken(place.column)) {
      if (place.y < above.bottom + spacing_.rows) place.y = above.bottom + spacing_.rows;
    }
    plan.column_count = std::max(plan.column_count, place.column + 1);
    plan.places[i] = place;
  }
}

void ColumnLayout::PlaceLayered(Plan& plan) const {
  Order order;
  for (std::size_t i = 0; i < plan.blocks.size(); ++i) {
    if (!plan.places[i] && plan.layers[i] >= 0) order.push_back(i);
  }
  // Neighbours in order of their peers: rank by the mean rank of peers, to and fro.
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
    const double y = NearestFree(plan.Taken(column), wanted, height, spacing_.rows);
    plan.places[i] = Place{plan.layers[i], column, y, height};
  }
}

void ColumnLayout::PlaceLoose(Plan& plan) const {
  const auto loose = std::count(plan.layers.begin(), plan.layers.end(), -1);
  // A few stand below one another, so that no edge from elsewhere passes behind one of them.
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
      if (plan.Bottom(other) < plan.Bottom(column)) column = other;
    }
    const double bottom = plan.Bottom(column);
    const double y = bottom == 0 ? 0 : bottom + spacing_.rows;
    plan.column_count = std::max(plan.column_count, column + 1);
    plan.places[i] = Place{-1, column, y, plan.blocks[i].size.height};
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

}  // namespace tendon::graph
