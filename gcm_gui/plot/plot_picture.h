#pragma once

#include <QString>
#include <functional>

class QObject;

namespace tendon::gui {

class PlotView;

/// Copies a picture of the plot, as it looks now, to the clipboard.
void CopyPicture(PlotView& view);

/// Saves a picture of the plot, as it looks now. If the name of `file` ends in .svg, the picture is
/// an SVG with scalable curves. Otherwise it is an image at double resolution. Another thread
/// encodes and writes the picture. Then `report` is called with a sentence for the user: the saved
/// file, or why saving failed. `report` is not called if `context` no longer exists.
void SavePicture(PlotView& view, const QString& file, const QObject* context,
                 const std::function<void(const QString& sentence)>& report);

}  // namespace tendon::gui
