#pragma once

#include <QRect>
#include <QSize>

namespace tendon::gui {

/// The place for a card of this size beside `shown`: the first of right, left, below and above that
/// fits into `room`; otherwise over the lower part of `shown`. Always within `room`.
[[nodiscard]] QRect CardBeside(const QRect& shown, const QSize& card, const QRect& room);

}  // namespace tendon::gui
