#include <gcm_gui/console/console_runner.h>
#include <gtest/gtest.h>
#include <program/exit_code.h>
#include <program/network_options.h>
#include <tendon/gcm/global_manager.h>

#include <QSignalSpy>
#include <QTest>

#include "support/folder.h"
#include "support/program.h"

namespace tendon::gui {
namespace {

constexpr int kConsoleTimeout = 60'000;  // ms

TEST(ConsoleRunner, ALineInterruptedBeforeItStartsEnds) {
  const test::Folder state;
  const program::NetworkOptions network;
  const auto gcm = GlobalManager::Start(
      *program::MakeMiddleware(network),
      {.address = "127.0.0.1:" + std::to_string(FreePort()), .state_folder = state.path()});
  ASSERT_TRUE(gcm) << gcm.error().message;
  console::Settings settings;
  settings.gcm = (*gcm)->address();
  settings.network = network;
  settings.timeout = std::chrono::seconds(20);
  ConsoleRunner runner(settings);
  QSignalSpy ends(&runner, &ConsoleRunner::finished);

  runner.run(QStringLiteral("log -f"), 80);
  runner.interrupt();

  ASSERT_TRUE(QTest::qWaitFor([&] { return ends.count() == 1; }, kConsoleTimeout));
  EXPECT_EQ(ends[0][0].toInt(), program::kInterrupted);
  EXPECT_FALSE(runner.isRunning());

  runner.run(QStringLiteral("status"), 80);  // the interruption was meant for the previous line
  ASSERT_TRUE(QTest::qWaitFor([&] { return ends.count() == 2; }, kConsoleTimeout));
  EXPECT_EQ(ends[1][0].toInt(), program::kOk);
}

}  // namespace
}  // namespace tendon::gui
