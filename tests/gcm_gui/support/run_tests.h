#pragma once

#include <gmock/gmock.h>

#include <QTemporaryDir>

namespace tendon::gui {

/// Runs all tests of the program under an application of this kind, without a screen. Neither the
/// desktop's look nor its user's folders decide what a test sees.
template <typename Application>
int RunTests(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  qunsetenv("DBUS_SESSION_BUS_ADDRESS");
  const QTemporaryDir runtime;
  qputenv("XDG_RUNTIME_DIR", runtime.path().toLocal8Bit());
  Application application(argc, argv);
  application.setProperty("tendonStill", true);  // what moves is where it is to be at once
  ::testing::InitGoogleMock(&argc, argv);
  return RUN_ALL_TESTS();
}

}  // namespace tendon::gui
