#include "window/window_fixture.h"

#include <gcm_gui/graph/graph_scene.h>
#include <gcm_gui/graph/graph_view.h>

#include <QTest>

#include "support/announcing.h"

namespace tendon::gui {

WindowFixture::WindowFixture(std::int64_t lost_since) : system_(LookSystem(lost_since)) {
  link_.setAddress("127.0.0.1:10705", true);
  link_.setConnected();
  Show();
  window_.show();
  window_.activateWindow();
  (void)QTest::qWaitForWindowActive(&window_, kTestTimeout);
}

void WindowFixture::Show() {
  store_.apply(system_.TakeChanges());
  EXPECT_TRUE(QTest::qWaitFor(
      [this] { return !IsAnnouncing(store_) && !window_.graph().graph().isArranging(); },
      kTestTimeout));
}

WindowParts WindowFixture::Parts() {
  WindowParts parts{store_, link_,   activity_, actions_, source_,
                    calls_, checks_, plans_,    reports_, recordings_};
  parts.demo = QStringLiteral(TENDON_DEMO_SYSTEM);
  return parts;
}

}  // namespace tendon::gui
