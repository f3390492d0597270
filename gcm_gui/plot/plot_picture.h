#pragma once

#include <QString>
#include <functional>

class QObject;

namespace tendon::gui {

class PlotView;

/// Copies the plot to the clipboard as it looks now.
void CopyPicture(PlotView& view);

/// Saves the plot as it looks now: as SVG with scalable curves if the name of `file` ends in .svg,
/// otherwise as an image at double resolution. Another thread encodes and writes it. Then `report`
/// is called, if `context` still exists, with a sentence for the user: the saved file, or the
/// reason of the failure.
void SavePicture(PlotView& view, const QString& file, const QObject* context,
                 const std::function<void(const QString& sentence)>& report);

}  // namespace tendon::gui
