#pragma once

#include <QRectF>
#include <QSizeF>
#include <vector>

namespace tendon::gui {

/// What is taken of the ground, so that what may stand anywhere is put beside it.
class FreeRoom {
 public:
  /// `between` is left around each.
  explicit FreeRoom(const QSizeF& between) : between_(between) {}

  void Take(const QRectF& rect) { taken_.push_back(rect); }
  /// Where a rectangle that would like to stand there can: there, or moved right or down by as
  /// little as it takes. Linear in what is taken, for each thing that is in the way.
  [[nodiscard]] QRectF Beside(QRectF wanted) const;

 private:
  [[nodiscard]] const QRectF* InTheWayOf(const QRectF& rect) const;

  QSizeF between_;
  std::vector<QRectF> taken_;
};

}  // namespace tendon::gui
