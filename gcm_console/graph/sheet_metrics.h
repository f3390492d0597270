#pragma once

/// The measures of a drawn system, in pixels.
namespace console::sheet {

inline constexpr double kMargin = 24;
inline constexpr double kLeastWidth = 360;  ///< of the space between the margins
inline constexpr double kTop = 64;          ///< the room for the title
inline constexpr double kBottom = 64;       ///< the room for the legend
inline constexpr double kBetweenProcesses = 96;
inline constexpr double kBelowProcesses = 28;
inline constexpr double kBetweenNodes = 80;
inline constexpr double kBelowNodes = 20;
inline constexpr double kProcessHead = 40;
inline constexpr double kProcessInset = 20;
inline constexpr double kNodeHead = 48;  ///< from a node's top to its ports
inline constexpr double kNodeTail = 8;
inline constexpr double kNodeInset = 14;
inline constexpr double kLeastNode = 128;
inline constexpr double kPortPitch = 22;
inline constexpr double kPortRadius = 4.5;
inline constexpr double kGap = 28;   ///< between two texts
inline constexpr double kMark = 14;  ///< the room for a mark in front of a text
inline constexpr double kTitleText = 16;
inline constexpr double kNameText = 14;
inline constexpr double kSmallText = 12;

}  // namespace console::sheet
