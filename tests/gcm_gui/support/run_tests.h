#pragma once

#include <gmock/gmock.h>

#include <QTemporaryDir>

namespace tendon::gui {

/// Runs all tests of the program with an application of this class, without a screen. The results
/// do not depend on the look of the desktop or on the user's folders.
template <typename Application>
int RunTests(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  qunsetenv("DBUS_SESSION_BUS_ADDRESS");
  const QTemporaryDir runtime;
  qputenv("XDG_RUNTIME_DIR", runtime.path().toLocal8Bit());
  Application application(argc, argv);
  application.setProperty("tendonStill", true);  // animations end at once
  ::testing::InitGoogleMock(&argc, argv);
  return RUN_ALL_TESTS();
}

}  // namespace tendon::gui
