#pragma once

#include <QByteArray>
#include <QString>
#include <optional>

namespace tendon::gui {

class PlotPanel;

/// Returns the contents of a layout file: the plots of each page. For each plot, the file contains
/// the paths of its signals, the time span, the motion, the value scale, and the look and axis of
/// each curve. The file contains no values, so the signals need not exist when the layout is
/// loaded.
[[nodiscard]] QByteArray LayoutOf(const PlotPanel& panel);

/// Replaces all plots by the plots of `layout`. A curve whose signal does not exist yet waits for
/// its signal. If the layout cannot be read, changes nothing and returns the reason.
[[nodiscard]] std::optional<QString> ShowLayout(PlotPanel& panel, const QByteArray& layout);

}  // namespace tendon::gui
