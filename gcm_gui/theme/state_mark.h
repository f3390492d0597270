#pragma once

#include <gcm_gui/theme/tokens.h>

#include <QString>

class QPainter;
class QRectF;

namespace tendon::gui {

/// What a component, a process, a port or an edge is found to be.
enum class StateMark {
  kConstructed,
  kReady,
  kActive,
  kSuspended,
  kFinished,
  kFaulted,
  kConnected,
  kPending,
  kNotConnected,
  kRefused,
  kWarning,
  kLost,
};
inline constexpr int kStateMarkCount = 12;

/// "active", "not connected", in the user's language: always shown or spoken beside the shape.
[[nodiscard]] QString WordOf(StateMark mark);
/// The same as the console says it, for filters.
[[nodiscard]] QString KeyOf(StateMark mark);

[[nodiscard]] Token ColorOf(StateMark mark);

/// The shape that tells it without colour: disc, ring, half disc, square, bars, triangle, cross.
/// Fills about 8 pixels of `rect`'s centre at 16 pixels, and grows with it.
void PaintMark(QPainter& painter, const QRectF& rect, StateMark mark);

}  // namespace tendon::gui
