#pragma once

#include <QRectF>
#include <QSizeF>
#include <vector>

namespace tendon::gui {

/// Keeps track of occupied space and finds free places beside it.
class FreeRoom {
 public:
  /// Keeps a gap of `between` around each rectangle.
  explicit FreeRoom(const QSizeF& between) : between_(between) {}

  void Take(const QRectF& rect) { taken_.push_back(rect); }
  /// Moves `wanted` right or down, one obstacle at a time, until it overlaps nothing. Each obstacle
  /// costs a pass over all occupied rectangles.
  [[nodiscard]] QRectF Beside(QRectF wanted) const;

 private:
  [[nodiscard]] const QRectF* InTheWayOf(const QRectF& rect) const;

  QSizeF between_;
  std::vector<QRectF> taken_;
};

}  // namespace tendon::gui
