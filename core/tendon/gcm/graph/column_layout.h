#pragma once

#include <tendon/gcm/graph/layers.h>

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tendon::graph {

/// In units of whoever draws.
struct Size {
  double width = 0;
  double height = 0;

  bool operator==(const Size&) const = default;
};

/// From its left upper corner; y grows downwards.
struct Rect {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;

  bool operator==(const Rect&) const = default;
};

/// Places blocks in columns, providers left of their clients. What has a place keeps it as long as
/// its layer stays and nothing grows into it; a new block goes to the free place nearest its peers.
/// Places are remembered, one for each layer, for blocks that come back.
class ColumnLayout {
 public:
  /// What is placed, by its name.
  struct Block {
    std::string key;
    Size size;
    bool keeps_place = true;  ///< else it stands where the others leave room

    bool operator==(const Block&) const = default;
  };
  /// Between what stands side by side, and one above the other.
  struct Spacing {
    double columns = 64;
    double rows = 16;
  };

  explicit ColumnLayout(Spacing spacing) : spacing_(spacing) {}

  /// Edges are indices of blocks, from provider to client. Nothing is done, and false returned,
  /// when they are those of the last time.
  bool Arrange(std::vector<Block> blocks, std::vector<LayerEdge> edges);

  /// Of a block of the last Arrange(), as wide as its column.
  [[nodiscard]] Rect rect(const std::string& key) const;
  /// All of it, from (0, 0).
  [[nodiscard]] Size size() const { return size_; }

 private:
  struct Place {
    int layer = 0;  // -1: it has no peers, and stands where there is room
    int column = 0;
    double y = 0;
    double height = 0;
  };
  using Order = std::vector<std::size_t>;

  struct Plan;  // of one Arrange()

  [[nodiscard]] Plan PlanFor(const std::vector<Block>& blocks,
                             const std::vector<LayerEdge>& edges) const;
  void KeepPlaces(Plan& plan) const;
  void PlaceLayered(Plan& plan) const;
  void PlaceLoose(Plan& plan) const;
  void Commit(const Plan& plan);

  Spacing spacing_;
  std::vector<Block> blocks_;  // of the last Arrange()
  std::vector<LayerEdge> edges_;
  std::map<std::pair<std::string, int>, Place> places_;  // by key and layer
  std::map<std::string, Rect> rects_;
  Size size_;
};

}  // namespace tendon::graph
