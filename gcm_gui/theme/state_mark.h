#pragma once

#include <gcm_gui/theme/tokens.h>

#include <QString>

class QPainter;
class QRectF;

namespace tendon::gui {

/// The state of a component, process, port or edge.
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
inline constexpr double kStaleMarkOpacity = 0.45;

/// Returns the state in the user's language: "active", "not connected". It is always shown or
/// spoken beside the shape.
[[nodiscard]] QString WordOf(StateMark mark);
/// Returns the state in the words of the console, for filters.
[[nodiscard]] QString KeyOf(StateMark mark);

[[nodiscard]] Token ColorOf(StateMark mark);

/// Draws a shape that shows the state without colour: disc, ring, half disc, square, bars, triangle
/// or cross. The shape is about 8 pixels wide in the centre of a 16-pixel `rect`, and scales with
/// `rect`.
void PaintMark(QPainter& painter, const QRectF& rect, StateMark mark);

}  // namespace tendon::gui
