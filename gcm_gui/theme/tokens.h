#pragma once

#include <QColor>

namespace tendon::gui {

/// The meaning of a colour. Views name colours only by these tokens.
enum class Token {
  kCanvas,  ///< behind and between the panels
  kPanel,   ///< a panel's surface
  kRaised,  ///< a button, a card, a node on a panel
  kLine,    ///< borders, grids
  kText,
  kDim,        ///< secondary text
  kAccent,     ///< selection, links, the suggested next action
  kOnAccent,   ///< text on a surface of kAccent
  kSelection,  ///< background of a selection
  kOk,
  kWarning,
  kBad,
  kStale,  ///< marks and lines of lost things; too faint for text; use kDim for text
};
inline constexpr int kTokenCount = 13;

enum class Appearance { kDark, kLight };

[[nodiscard]] QColor ColorOf(Token token, Appearance appearance);

/// The colours of Okabe and Ito, adapted for contrast with kPanel. The colours repeat after
/// kCurveColorCount.
[[nodiscard]] QColor CurveColor(int index, Appearance appearance);
inline constexpr int kCurveColorCount = 8;

}  // namespace tendon::gui
