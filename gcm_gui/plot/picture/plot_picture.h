#pragma once

#include <QString>

namespace tendon::gui {

class PlotView;

/// To the clipboard, as it is seen.
void CopyPicture(PlotView& view);

/// As SVG where the file is named so, with curves as lines that can be scaled; else as an image of
/// twice the points. Returns a sentence for the user: what was saved, or why not.
[[nodiscard]] QString SavePicture(PlotView& view, const QString& file);

}  // namespace tendon::gui
