#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>

#include <QPointF>
#include <QRectF>
#include <QSizeF>

namespace tendon::gui {

// Measures of the graph, in scene units, which are pixels at 100 %.
inline constexpr double kPortPitch = 20;
inline constexpr double kPortRadius = 5;
inline constexpr double kNodeHead = 28;  ///< from a node's top to the room of its ports
inline constexpr double kNodeTail = 6;
inline constexpr double kNodeInset = 12;
inline constexpr double kPortInset = 16;    ///< from a node's edge to a port's name, past its rings
inline constexpr double kProcessHead = 28;  ///< from a process box's top to its nodes
inline constexpr double kProcessInset = 14;

/// Below this scale names cannot be read: less is drawn.
inline constexpr double kFarAway = 0.35;

// What lies above the veil that dims all else of the graph.
inline constexpr double kVeil = 5;
inline constexpr double kRaisedEdge = 6;
inline constexpr double kRaisedNode = 7;
inline constexpr double kReadout = 8;

/// What a node needs with the fonts of the theme.
[[nodiscard]] QSizeF SizeOf(const NodePicture& node);

/// What the title of a process box needs, however long it has been lost.
[[nodiscard]] double WidthOfTitle(const QString& process);

/// The middle of a port's disc. `index` counts the ports of its side from above.
[[nodiscard]] QPointF PortCentre(const QRectF& node, Side side, int index);

}  // namespace tendon::gui
