#pragma once

#include <QRect>
#include <QSize>

namespace tendon::gui {

/// Where a card of this size stands beside `shown`: at its right, left, below or above, wherever it
/// fits into `room` first; else in the lower part of what is shown. Never outside of `room`.
[[nodiscard]] QRect CardBeside(const QRect& shown, const QSize& card, const QRect& room);

}  // namespace tendon::gui
