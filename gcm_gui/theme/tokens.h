#pragma once

#include <QColor>

namespace tendon::gui {

/// What a colour means: the only way in which a view names one.
enum class Token {
  kCanvas,  ///< behind and between the panels
  kPanel,   ///< a panel's surface
  kRaised,  ///< a button, a card, a node on a panel
  kLine,    ///< borders, grids
  kText,
  kDim,        ///< secondary text
  kAccent,     ///< selection, links, the thing to do next
  kOnAccent,   ///< text on a surface of kAccent
  kSelection,  ///< behind what is selected
  kOk,
  kWarning,
  kBad,
  kStale,  ///< marks and lines of what is lost; too faint for text, which is kDim then
};
inline constexpr int kTokenCount = 13;

enum class Appearance { kDark, kLight };

[[nodiscard]] QColor ColorOf(Token token, Appearance appearance);

/// The colours of Okabe and Ito, each adapted to stand out from kPanel. Repeats after
/// kCurveColorCount.
[[nodiscard]] QColor CurveColor(int index, Appearance appearance);
inline constexpr int kCurveColorCount = 8;

}  // namespace tendon::gui
