#include "window/window_fixture.h"

#include <QTest>

namespace tendon::gui {

WindowFixture::WindowFixture(std::int64_t lost_since) : system_(LookSystem(lost_since)) {
  link_.setAddress("127.0.0.1:10705", true);
  link_.setConnected();
  Show();
  window_.show();
  window_.activateWindow();
  (void)QTest::qWaitForWindowActive(&window_, kPatience);
}

}  // namespace tendon::gui
