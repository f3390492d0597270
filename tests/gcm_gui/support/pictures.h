#pragma once

#include <QString>

class QWidget;

namespace tendon::gui {

/// Saves the window as it looks, dark and light, with one dot and with two a point, for people:
/// `name`-dark-1x.png and so on, in the folder of the pictures of all tests. Leaves it light.
void KeepPictures(QWidget& window, const QString& name);

}  // namespace tendon::gui
