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

/// A rectangle, given by its upper left corner and its size. y grows downwards.
struct Rect {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;

  bool operator==(const Rect&) const = default;
};

/// An edge from a provider to its client, as indices of the two blocks.
struct LayerEdge {
  std::size_t from = 0;
  std::size_t to = 0;

  bool operator==(const LayerEdge&) const = default;
};

/// Places the components of a graph as blocks in columns, with providers to the left of their
/// clients. A block keeps its position as long as its layer stays the same and no block above it
/// grows into it. A new block gets the free position nearest to its peers. A block that was removed
/// and comes back gets its last position in its layer.
class ColumnLayout {
 public:
  /// An object to place, with its name.
  struct Block {
    std::string key;
    Size size;
    bool keeps_place = true;  ///< if false, the block is placed last, where the other blocks leave
                              ///< room

    bool operator==(const Block&) const = default;
  };
  /// Gaps between columns and between blocks in a column.
  struct Spacing {
    double columns = 64;
    double rows = 16;
  };

  explicit ColumnLayout(Spacing spacing) : spacing_(spacing) {}

  /// Computes the position of each block. The edges are indices into `blocks`. Returns false and
  /// does nothing if blocks and edges are the same as in the last call.
  bool Arrange(std::vector<Block> blocks, std::vector<LayerEdge> edges);

  /// Returns the rectangle of a block after the last Arrange(). It is as wide as its column.
  [[nodiscard]] Rect rect(const std::string& key) const;
  /// The size of the whole layout, which begins at (0, 0).
  [[nodiscard]] Size size() const { return size_; }

 private:
  struct Place {
    int layer = 0;  // -1: the block has no peers
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
  std::map<std::pair<std::string, int>, Place> places_;  // by key of the block and layer
  std::map<std::string, Rect> rects_;
  Size size_;
};

/// Assigns a layer to each of `count` nodes, so that each edge leads to a higher layer. The layer
/// of a node is the length of the longest path to it. A path begins at a node without providers. An
/// edge that closes a cycle is ignored.
[[nodiscard]] std::vector<int> LayersOf(std::size_t count, const std::vector<LayerEdge>& edges);

}  // namespace tendon::graph
