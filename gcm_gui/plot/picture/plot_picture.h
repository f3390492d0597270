#pragma once

#include <QString>
#include <functional>

class QObject;

namespace tendon::gui {

class PlotView;

/// To the clipboard, as it is seen.
void CopyPicture(PlotView& view);

/// As SVG where the file is named so, with curves as lines that can be scaled; else as an image of
/// twice the points. As it is seen now; it is encoded and written in a thread of its own, and then
/// `told`, unless `context` is gone, hears a sentence for the user: what was saved, or why not.
void SavePicture(PlotView& view, const QString& file, const QObject* context,
                 const std::function<void(const QString& sentence)>& told);

}  // namespace tendon::gui
