#pragma once

#include <gcm_gui/graph/layout/layers.h>

#include <QHash>
#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QString>
#include <utility>
#include <vector>

namespace tendon::gui {

/// Places blocks in columns, providers left of their clients. What has a place keeps it as long as
/// its layer stays and nothing grows into it; a new block goes to the free place nearest its peers.
/// Places are remembered, one for each layer, for blocks that come back.
class ColumnLayout {
 public:
  struct Block {
    QString key;
    QSizeF size;
    bool keeps_place = true;  ///< else it stands where the others leave room

    bool operator==(const Block&) const = default;
  };
  struct Spacing {
    double columns = 64;
    double rows = 16;
  };

  explicit ColumnLayout(Spacing spacing) : spacing_(spacing) {}

  /// Edges are indices of blocks, from provider to client. Nothing is done, and false returned,
  /// when they are those of the last time.
  bool arrange(std::vector<Block> blocks, std::vector<LayerEdge> edges);

  /// Of a block of the last arrange(), as wide as its column.
  [[nodiscard]] QRectF rect(const QString& key) const { return rects_.value(key); }
  /// All of it, from (0, 0).
  [[nodiscard]] QSizeF size() const { return size_; }

 private:
  struct Place {
    int layer = 0;  // -1: it has no peers, and stands where there is room
    int column = 0;
    double y = 0;
    double height = 0;
  };
  using Order = std::vector<std::size_t>;

  struct Plan;  // of one arrange()

  [[nodiscard]] Plan planFor(const std::vector<Block>& blocks,
                             const std::vector<LayerEdge>& edges) const;
  void keepPlaces(Plan& plan) const;
  void placeLayered(Plan& plan) const;
  void placeLoose(Plan& plan) const;
  void commit(const Plan& plan);

  Spacing spacing_;
  std::vector<Block> blocks_;  // of the last arrange()
  std::vector<LayerEdge> edges_;
  QHash<std::pair<QString, int>, Place> places_;  // by key and layer
  QHash<QString, QRectF> rects_;
  QSizeF size_;
};

}  // namespace tendon::gui
