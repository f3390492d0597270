#pragma once

#include <QByteArray>
#include <QString>
#include <optional>

namespace tendon::gui {

class PlotPanel;

/// The plots as a file: the paths of each plot, the plots of each page, and per plot the time span,
/// the motion, the value scale and the look and axis of each curve. It contains paths and no
/// values, so the signals need not exist when it is loaded.
[[nodiscard]] QByteArray LayoutOf(const PlotPanel& panel);

/// Replaces the plots by those of `layout`; waits for signals that do not exist yet. If the layout
/// cannot be read, returns the reason and changes nothing.
[[nodiscard]] std::optional<QString> ShowLayout(PlotPanel& panel, const QByteArray& layout);

}  // namespace tendon::gui
