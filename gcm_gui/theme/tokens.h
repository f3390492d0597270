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
  kSelection,  ///< the background of selected items
  kOk,
  kWarning,
  kBad,
  kStale,  ///< marks and lines of lost objects; too faint for text: use kDim
};
inline constexpr int kTokenCount = 13;

enum class Appearance { kDark, kLight };

[[nodiscard]] QColor ColorOf(Token token, Appearance appearance);

/// Returns the colour of a curve: the colours of Okabe and Ito, adapted for contrast with kPanel.
/// They repeat after kCurveColorCount.
[[nodiscard]] QColor CurveColor(int index, Appearance appearance);
inline constexpr int kCurveColorCount = 8;

}  // namespace tendon::gui
