#pragma once

namespace tendon::gui {

// The base grid, in logical pixels.
inline constexpr int kGrid = 4;
inline constexpr int kRowHeight = 24;
inline constexpr int kHeadHeight = 32;  ///< panel heads and tab bars
inline constexpr int kTopBarHeight = 40;
inline constexpr int kInset = 12;  ///< from a panel's edge to its contents
inline constexpr int kGap = 1;     ///< gap of canvas colour between panels
inline constexpr int kRadius = 6;
inline constexpr int kIndent = 14;  ///< one level of a tree

inline constexpr int kTextSize = 13;
inline constexpr int kMonoSize = 12;
inline constexpr int kSmallSize = 11;  ///< pixels; the font of axes and legends

}  // namespace tendon::gui
