#include <gcm_gui/replay/replay_session.h>
#include <gmock/gmock.h>

#include <QTemporaryDir>
#include <QTest>
#include <cstdint>
#include <functional>
#include <memory>
#include <set>

#include "replay/recorded_file.h"
#include "replay/stoppable_disk.h"

namespace tendon::gui {
namespace {

using testing::ElementsAre;
using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;
using State = ReplaySession::State;

constexpr int kSessionTimeout = 120'000;  // ms; bounds a test that fails

/// A session whose disk stops while it reads. A function that waits for the disk would block until
/// it gives up, and then report the unfinished reading on stderr.
class ReplayFromASlowDisk : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(folder_.isValid());
    const QString file = folder_.filePath("run.mcap");
    WriteRun(file);
    session_ = std::make_unique<ReplaySession>(file, disk_.opener());
    ASSERT_TRUE(Eventually([this] { return IsShowing(); }));
    QObject::connect(session_.get(), &ReplaySession::moved, session_.get(),
                     [this] { shown_.insert(session_->position()); });
  }
  static bool Eventually(const std::function<bool()>& holds) {
    return QTest::qWaitFor(holds, kSessionTimeout);
  }
  [[nodiscard]] bool IsShowing() const {
    return session_->state() == State::kOpen && !session_->isJumping();
  }
  /// Begins to go to this moment, and stops the disk during the reading.
  void BeginToSeek(std::int64_t time) {
    disk_.stop();
    session_->seek(time);
    ASSERT_TRUE(Eventually([this] { return disk_.counts().waiting == 1; }));
  }

  QTemporaryDir folder_;
  StoppableDisk disk_;
  std::unique_ptr<ReplaySession> session_;
  std::set<std::int64_t> shown_;  // moments
};

TEST_F(ReplayFromASlowDisk, OpensTheFileAgainWithoutWaiting) {
  BeginToSeek(kRunBegin + 18 * kSecond);

  CaptureStderr();
  session_->reload();
  EXPECT_EQ(GetCapturedStderr(), "");

  EXPECT_EQ(session_->state(), State::kOpening);
  EXPECT_GE(disk_.counts().waiting, 1);
  disk_.go();
  ASSERT_TRUE(Eventually([this] { return IsShowing(); }));
  EXPECT_THAT(shown_, ElementsAre(kRunBegin)) << "the result of the former reading is dropped";
  EXPECT_TRUE(Eventually([this] { return disk_.counts().open_files == 1; }));
}

TEST_F(ReplayFromASlowDisk, GoesToAnotherMomentWithoutWaiting) {
  BeginToSeek(kRunBegin + 18 * kSecond);

  session_->seek(kRunBegin + 15 * kSecond);

  EXPECT_TRUE(session_->isJumping());
  EXPECT_EQ(disk_.counts().waiting, 1);
  EXPECT_THAT(shown_, ElementsAre());
  disk_.go();
  EXPECT_TRUE(Eventually(
      [this] { return IsShowing() && session_->position() == kRunBegin + 15 * kSecond; }));
}

TEST_F(ReplayFromASlowDisk, EndsWithoutWaiting) {
  BeginToSeek(kRunBegin + 18 * kSecond);

  CaptureStderr();
  session_.reset();
  EXPECT_EQ(GetCapturedStderr(), "");

  EXPECT_EQ(disk_.counts().waiting, 1);
  disk_.go();
  EXPECT_TRUE(Eventually([this] { return disk_.counts().open_files == 0; }));
  EXPECT_THAT(shown_, ElementsAre());
}

}  // namespace
}  // namespace tendon::gui
