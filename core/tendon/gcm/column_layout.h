#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tendon::graph {

/// A size, in units of the drawing.
struct Size {
  double width = 0;
  double height = 0;

  bool operator==(const Size&) const = default;
};

/// A rectangle: upper left corner and size; y grows downwards.
struct Rect {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;

  bool operator==(const Rect&) const = default;
};

/// From a provider to its client, by index.
struct LayerEdge {
  std::size_t from = 0;
  std::size_t to = 0;

  bool operator==(const LayerEdge&) const = default;
};

/// Places the components of a graph as blocks in columns, providers left of their clients. A placed
/// block stays as long as its layer is the same and no other block grows into it. A new block goes
/// to the free place nearest its peers. Remembers the places of removed blocks, one for each layer,
/// in case they come back.
class ColumnLayout {
 public:
  /// An object to place, with its name.
  struct Block {
    std::string key;
    Size size;
    bool keeps_place = true;  ///< false: it goes where the others leave room

    bool operator==(const Block&) const = default;
  };
  /// Gaps between columns and between blocks in a column.
  struct Spacing {
    double columns = 64;
    double rows = 16;
  };

  explicit ColumnLayout(Spacing spacing) : spacing_(spacing) {}

  /// Edges are indices of blocks, from provider to client. Returns false and does nothing if blocks
  /// and edges are the same as in the last call.
  bool Arrange(std::vector<Block> blocks, std::vector<LayerEdge> edges);

  /// The place of a block of the last Arrange(), as wide as its column.
  [[nodiscard]] Rect rect(const std::string& key) const;
  /// The whole layout, from (0, 0).
  [[nodiscard]] Size size() const { return size_; }

 private:
  struct Place {
    int layer = 0;  // -1: has no peers, and is put where there is room
    int column = 0;
    double y = 0;
    double height = 0;
  };
  using Order = std::vector<std::size_t>;

  struct Plan;  // the data of one Arrange()

  [[nodiscard]] Plan PlanFor(const std::vector<Block>& blocks,
                             const std::vector<LayerEdge>& edges) const;
  void KeepPlaces(Plan& plan) const;
  void PlaceLayered(Plan& plan) const;
  void PlaceLoose(Plan& plan) const;
  void Commit(const Plan& plan);

  Spacing spacing_;
  std::vector<Block> blocks_;  // blocks of the last Arrange()
  std::vector<LayerEdge> edges_;
  std::map<std::pair<std::string, int>, Place> places_;  // by key and layer
  std::map<std::string, Rect> rects_;
  Size size_;
};

/// Assigns a layer to each of `count` nodes, so that each edge leads to a higher layer. The layer
/// is the length of the longest path from a node without providers. Ignores each edge that closes a
/// cycle.
[[nodiscard]] std::vector<int> LayersOf(std::size_t count, const std::vector<LayerEdge>& edges);

}  // namespace tendon::graph
