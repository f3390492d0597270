#include <gcm_gui/recording/recording_runner.h>
#include <gcm_gui/recording/recording_words.h>
#include <gtest/gtest.h>

namespace tendon::gui {
namespace {

TEST(RecordingWords, ALengthHasMinutesAndSeconds) {
  EXPECT_EQ(LengthText(0.0), "0:00");
  EXPECT_EQ(LengthText(7.9), "0:07");
  EXPECT_EQ(LengthText(750.0), "12:30");
  EXPECT_EQ(LengthText(3725.0), "1:02:05");
}

TEST(RecordingWords, EveryLossIsCountedAndHasItsPlace) {
  recording::Losses losses;
  losses.rows["robot/arm/state"] = {.table = 12, .network = 3, .viewer = 100};
  losses.rows["robot/drive/state"] = {};
  losses.events["robot/arm/Control.Stopped"] = 2;
  losses.log = 4;

  EXPECT_EQ(losses.all(), 121U);
  EXPECT_EQ(
      LossLines(losses),
      (QStringList{"robot/arm/state: rows lost: 12 in its process, 3 on the network, 100 in this "
                   "window, because the disk was too slow",
                   "robot/arm/Control.Stopped: events lost: 2", "Records of the log lost: 4"}));
}

TEST(RecordingWords, ADiskThatIsFullSoonIsSaid) {
  RecordingProgress progress;
  progress.status.disk_free = 40'000'000'000;
  progress.rate = 1e6;
  EXPECT_EQ(DiskWarning(progress), "");

  progress.rate = 400e6;
  EXPECT_TRUE(DiskWarning(progress).contains("full in 1:40"))
      << DiskWarning(progress).toStdString();

  progress.rate = 0;
  EXPECT_EQ(DiskWarning(progress), "");
  progress.status.disk_free = 400'000'000;
  EXPECT_EQ(DiskWarning(progress), "The disk is almost full.");
}

}  // namespace
}  // namespace tendon::gui
