#pragma once

class QWidget;

namespace tendon::gui {

/// Shows a window, not modal, with the name of the program and the versions of its parts.
void ShowAbout(QWidget& window);

}  // namespace tendon::gui
