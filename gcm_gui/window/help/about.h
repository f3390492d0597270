#pragma once

class QWidget;

namespace tendon::gui {

/// What this program is and the versions it is made of, in a window that waits for nobody.
void ShowAbout(QWidget& window);

}  // namespace tendon::gui
