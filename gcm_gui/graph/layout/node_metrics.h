#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>

#include <QPointF>
#include <QRectF>
#include <QSizeF>

namespace tendon::gui {

// Sizes in the graph in scene units, which are pixels at 100 %.
inline constexpr double kPortPitch = 20;
inline constexpr double kPortRadius = 5;
inline constexpr double kNodeHead = 28;  ///< from a node's top to its ports
inline constexpr double kNodeTail = 6;
inline constexpr double kNodeInset = 12;
inline constexpr double kPortInset = 16;    ///< from a node's edge to a port's name
inline constexpr double kProcessHead = 28;  ///< from a process box's top to its nodes
inline constexpr double kProcessInset = 14;

/// Below this scale names are unreadable, so fewer details are drawn.
inline constexpr double kFarAway = 0.35;

// The z values of the DimmingItem and of the items above it.
inline constexpr double kDimming = 5;
inline constexpr double kRaisedEdge = 6;
inline constexpr double kRaisedNode = 7;
inline constexpr double kReadout = 8;

/// Returns the size that a node needs in the theme's fonts.
[[nodiscard]] QSizeF SizeOf(const NodePicture& node);

/// Returns the width that the title of a process box needs, even with a long text such as "lost 12
/// s".
[[nodiscard]] double WidthOfTitle(const QString& process);

/// Returns the centre of a port's disc. `index` counts the ports on the same side of the node from
/// the top.
[[nodiscard]] QPointF PortCentre(const QRectF& node, Side side, int index);

}  // namespace tendon::gui
