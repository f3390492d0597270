#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/tour/card_beside.h>

#include <algorithm>
#include <array>

namespace tendon::gui {
namespace {

constexpr int kAway = kInset;

QRect MovedInto(QRect card, const QRect& room) {
  card.moveLeft(std::max(room.left(), std::min(card.left(), room.right() + 1 - card.width())));
  card.moveTop(std::max(room.top(), std::min(card.top(), room.bottom() + 1 - card.height())));
  return card;
}

}  // namespace

QRect CardBeside(const QRect& shown, const QSize& card, const QRect& room) {
  QRect centred({}, card);
  centred.moveCenter(shown.center());
  const int right = shown.right() + 1 + kAway;
  const int left = shown.left() - kAway - card.width();
  const int below = shown.bottom() + 1 + kAway;
  const int above = shown.top() - kAway - card.height();
  const std::array places{QPoint(right, centred.top()), QPoint(left, centred.top()),
                          QPoint(centred.left(), below), QPoint(centred.left(), above)};
  for (const QPoint& place : places) {
    const QRect moved = MovedInto({place, card}, room);
    if (room.contains(moved) && !moved.intersects(shown)) return moved;
  }
  centred.moveBottom(shown.bottom() - kAway);
  return MovedInto(centred, room);
}

}  // namespace tendon::gui
