#include <gcm_gui/graph/layout/free_room.h>

namespace tendon::gui {

const QRectF* FreeRoom::InTheWayOf(const QRectF& rect) const {
  for (const QRectF& taken : taken_) {
    if (taken.intersects(rect)) return &taken;
  }
  return nullptr;
}

QRectF FreeRoom::Beside(QRectF wanted) const {
  // The loop ends, because each step moves right or down past one obstacle.
  while (const QRectF* obstacle = InTheWayOf(wanted)) {
    const double right = obstacle->right() + between_.width() - wanted.left();
    const double down = obstacle->bottom() + between_.height() - wanted.top();
    right < down ? wanted.translate(right, 0) : wanted.translate(0, down);
  }
  return wanted;
}

}  // namespace tendon::gui
