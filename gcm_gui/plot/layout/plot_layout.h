#pragma once

#include <QByteArray>
#include <QString>
#include <optional>

namespace tendon::gui {

class PlotPanel;

/// The plots as a file: which paths are in which plot, which plots lie below each other, how far
/// each looks back, how it moves, whether its values are logarithmic, and what of the curves is
/// hidden or scaled, and on which axis. It holds
/// paths and no values, so what it names may come later, or again.
[[nodiscard]] QByteArray LayoutOf(const PlotPanel& panel);

/// Puts the plots of `layout` in place of those there are. A signal that is not there is waited
/// for. Returns why it cannot be read, and then leaves everything as it was.
[[nodiscard]] std::optional<QString> ShowLayout(PlotPanel& panel, const QByteArray& layout);

}  // namespace tendon::gui
