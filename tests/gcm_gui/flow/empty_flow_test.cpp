#include <gcm_gui/help/tour.h>

#include <QDir>
#include <QFile>
#include <QPushButton>
#include <csignal>

#include "flow/flow_fixture.h"
#include "support/pictures.h"

namespace tendon::gui {
namespace {

/// Returns the command line of a process; empty if the process has ended.
QByteArray CommandLineOf(const QString& pid) {
  QFile words("/proc/" + pid + "/cmdline");
  return words.open(QIODevice::ReadOnly) ? words.readAll() : QByteArray();
}

/// At first, no program runs.
class EmptyFlow : public FlowFixture {
 protected:
  void SetUp() override {
    qputenv("XDG_STATE_HOME", home_.path().c_str());
    ASSERT_NO_FATAL_FAILURE(OpenWindow());
  }
  /// Ends the programs that the window has started; they would outlive the window.
  void TearDown() override {
    FlowFixture::TearDown();
    for (const QString& pid : QDir("/proc").entryList({"[0-9]*"}, QDir::Dirs)) {
      const QByteArray line = CommandLineOf(pid);
      const bool is_ours = line.contains(address_.c_str()) && line.contains("serve");
      if (!is_ours) continue;
      ::kill(pid.toInt(), SIGTERM);
      EXPECT_TRUE(Eventually([&] { return CommandLineOf(pid).isEmpty(); }));
    }
    qunsetenv("XDG_STATE_HOME");
  }
};

TEST_F(EmptyFlow, OneClickStartsAGcm) {
  ASSERT_TRUE(Eventually([this] { return Find<QPushButton>("startGcm").isVisible(); }));
  EXPECT_FALSE(Find<QPushButton>("tryDemo").isVisible());
  KeepPictures(*window_, "flow-empty");

  Click(Find<QPushButton>("startGcm"));

  EXPECT_TRUE(
      Eventually([this] { return session_->link().state() == LinkState::State::kConnected; }));
  EXPECT_TRUE(Eventually([this] { return Find<QPushButton>("tryDemo").isVisible(); }));
  EXPECT_FALSE(Find<QPushButton>("startGcm").isVisible());
  KeepPictures(*window_, "flow-empty-gcm");
}

TEST_F(EmptyFlow, AClickStartsTheTour) {
  Click(Find<QPushButton>("showAround"));

  EXPECT_TRUE(window_->tour().isRunning());
}

}  // namespace
}  // namespace tendon::gui
