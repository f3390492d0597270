#pragma once

#include <QString>

class QWidget;

namespace tendon::gui {

/// Saves pictures of the window for people, dark and light, with one and with two pixels per point:
/// `name`-dark-1x.png and so on, in the folder of the pictures of all tests. Leaves the window
/// light.
void KeepPictures(QWidget& window, const QString& name);

}  // namespace tendon::gui
