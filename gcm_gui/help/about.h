#pragma once

class QWidget;

namespace tendon::gui {

/// Shows the program and the versions of its parts, in a window that is not modal.
void ShowAbout(QWidget& window);

}  // namespace tendon::gui
