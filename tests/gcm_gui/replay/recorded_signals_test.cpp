#include <gcm_gui/plot/series/shown_time.h>
#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/plot/series/time_shift.h>
#include <gcm_gui/replay/recorded_signals.h>
#include <gmock/gmock.h>

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <map>
#include <vector>

#include "replay/recorded_file.h"
#include "replay/stoppable_disk.h"

namespace tendon::gui {
namespace {

using testing::HasSubstr;

constexpr int kSignalTimeout = 120'000;  // ms; bounds a test that fails
constexpr auto kTimeSignal = "robot/arm/state.Joints.position[0]";
constexpr auto kWaveSignal = "robot/arm/state.Joints.position[1]";

/// A recording of 20 s, see WriteRun(), whose signals are read as plots would. Seconds are those of
/// the recording.
class RecordedSignalsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(folder_.isValid());
    file_ = folder_.filePath("run.mcap");
    connect();
  }
  void connect() {
    QObject::connect(&signals_, &SignalSource::samplesArrived, &signals_,
                     [this](const QString& signal, std::span<const Sample> samples) {
                       auto& all = samples_[SignalOf(signal)];
                       all.insert(all.end(), samples.begin(), samples.end());
                     });
    QObject::connect(&signals_, &SignalSource::wentStale, &signals_,
                     [this](const QString& signal, const QString& reason) {
                       reasons_[SignalOf(signal)] = reason;
                     });
    QObject::connect(&signals_, &RecordedSignals::readAgain, &signals_, [this] {
      samples_.clear();
      ++jumps_;
    });
  }
  static std::int64_t At(double seconds) {
    return MovedTime(kRunBegin + static_cast<std::int64_t>(seconds * kSecond), -WallOffset());
  }
  void See(double from, double to) { seen_ = {.from_ns = At(from), .to_ns = At(to)}; }
  void Subscribe(const char* signal) { signals_.subscribe(RecordedPath(file_, signal)); }
  static bool Eventually(const std::function<bool()>& holds) {
    return QTest::qWaitFor(holds, kSignalTimeout);
  }
  [[nodiscard]] bool Covers(const char* signal, double from, double to) {
    const auto& all = samples_[signal];
    return !all.empty() && all.front().time_ns <= At(from) && all.back().time_ns >= At(to);
  }

  QTemporaryDir folder_;
  QString file_;
  TimeSpan seen_;
  std::map<QString, std::vector<Sample>> samples_;
  std::map<QString, QString> reasons_;
  int jumps_ = 0;
  RecordedSignals signals_{[this](const QString&) { return std::optional(seen_); }};
};

TEST_F(RecordedSignalsTest, TheSeenPartIsReadAtItsTimeAndNotTheWholeFile) {
  WriteRun(file_);
  See(4, 6);
  Subscribe(kTimeSignal);

  ASSERT_TRUE(Eventually([this] { return Covers(kTimeSignal, 4, 6); }));

  const auto& all = samples_[kTimeSignal];
  EXPECT_GE(all.front().time_ns, At(2.9));
  EXPECT_LE(all.back().time_ns, At(7.1));
  for (const Sample& sample : all) {
    ASSERT_NEAR(static_cast<double>(sample.time_ns - At(0)) / kSecond, sample.value.nearest(),
                1e-6);
  }
}

TEST_F(RecordedSignalsTest, AViewThatMovesOnReadsOnlyWhatIsNew) {
  WriteRun(file_);
  See(0, 2);
  Subscribe(kTimeSignal);
  ASSERT_TRUE(Eventually([this] { return Covers(kTimeSignal, 0, 2); }));

  See(1, 4);
  ASSERT_TRUE(Eventually([this] { return Covers(kTimeSignal, 0, 4); }));

  EXPECT_EQ(jumps_, 1);
  const auto& all = samples_[kTimeSignal];
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), [](const Sample& a, const Sample& b) {
    return a.time_ns < b.time_ns;
  }));
}

TEST_F(RecordedSignalsTest, AViewThatMovesBackIsReadAgain) {
  WriteRun(file_);
  See(14, 16);
  Subscribe(kTimeSignal);
  ASSERT_TRUE(Eventually([this] { return Covers(kTimeSignal, 14, 16); }));

  See(2, 4);

  ASSERT_TRUE(Eventually([this] { return Covers(kTimeSignal, 2, 4); }));
  EXPECT_LT(samples_[kTimeSignal].back().time_ns, At(6));
}

TEST_F(RecordedSignalsTest, ASignalThatIsAddedLaterHasThePastToo) {
  WriteRun(file_);
  See(4, 6);
  Subscribe(kTimeSignal);
  ASSERT_TRUE(Eventually([this] { return Covers(kTimeSignal, 4, 6); }));

  Subscribe(kWaveSignal);

  ASSERT_TRUE(
      Eventually([this] { return Covers(kWaveSignal, 4, 6) && Covers(kTimeSignal, 4, 6); }));
}

TEST_F(RecordedSignalsTest, OutsideOfTheRecordingThereIsNothing) {
  WriteRun(file_);
  See(100, 130);
  Subscribe(kTimeSignal);

  ASSERT_TRUE(Eventually([this] { return jumps_ == 1; }));
  EXPECT_TRUE(samples_.empty());

  See(-10, 3);
  ASSERT_TRUE(Eventually([this] { return Covers(kTimeSignal, 0.01, 3); }));
}

TEST_F(RecordedSignalsTest, ItsTimeIsToldWhenItIsOpen) {
  WriteRun(file_);
  QSignalSpy opened(&signals_, &RecordedSignals::opened);
  Subscribe(kTimeSignal);

  ASSERT_TRUE(opened.wait(kSignalTimeout));
  EXPECT_EQ(opened[0][0], file_);
  EXPECT_EQ(opened[0][1].value<TimeSpan>().from_ns, At(0));
}

TEST_F(RecordedSignalsTest, AMissingFileIsRefusedWithItsName) {
  QSignalSpy notice(&signals_, &RecordedSignals::notice);
  Subscribe(kTimeSignal);

  ASSERT_TRUE(notice.wait(kSignalTimeout));
  EXPECT_THAT(notice[0][0].toString().toStdString(), HasSubstr("run.mcap"));
  EXPECT_NE(reasons_[kTimeSignal], "");

  Subscribe(kWaveSignal);
  EXPECT_EQ(reasons_[kWaveSignal], reasons_[kTimeSignal]);
}

TEST_F(RecordedSignalsTest, AFileThatIsNoRecordingIsRefused) {
  QFile file(file_);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("time,value\n1,2\n");
  file.close();
  QSignalSpy notice(&signals_, &RecordedSignals::notice);
  Subscribe(kTimeSignal);

  ASSERT_TRUE(notice.wait(kSignalTimeout));
  EXPECT_NE(reasons_[kTimeSignal], "");
}

TEST_F(RecordedSignalsTest, ADamagedFileIsReadAsFarAsItGoesAndSaysSo) {
  WriteRun(file_, FileEnd::kMissing);
  QSignalSpy notice(&signals_, &RecordedSignals::notice);
  See(0, 30);
  Subscribe(kTimeSignal);

  ASSERT_TRUE(Eventually([this] { return Covers(kTimeSignal, 0, 10); }));
  ASSERT_GE(notice.count(), 1);
  EXPECT_THAT(notice[0][0].toString().toStdString(), HasSubstr("run.mcap is damaged"));
}

TEST_F(RecordedSignalsTest, ASignalThatIsNotThereSaysSo) {
  WriteRun(file_);
  See(0, 5);
  Subscribe("robot/arm/state.Nothing");
  Subscribe("robot/arm/state.Joints.torque");
  Subscribe(kTimeSignal);

  ASSERT_TRUE(Eventually([this] { return Covers(kTimeSignal, 0, 5); }));
  EXPECT_THAT(reasons_["robot/arm/state.Nothing"].toStdString(), HasSubstr("does not contain"));
  EXPECT_THAT(reasons_["robot/arm/state.Joints.torque"].toStdString(), HasSubstr("torque"));
}

TEST_F(RecordedSignalsTest, AFileThatVanishesKeepsWhatWasRead) {
  WriteRun(file_);
  See(0, 2);
  Subscribe(kTimeSignal);
  ASSERT_TRUE(Eventually([this] { return Covers(kTimeSignal, 0, 2); }));
  ASSERT_TRUE(QFile::remove(file_));

  See(1, 6);

  ASSERT_TRUE(Eventually([this] {
    return reasons_[kTimeSignal].contains(QStringLiteral("does not exist any more"));
  }));
  EXPECT_TRUE(Covers(kTimeSignal, 0, 2));
}

TEST_F(RecordedSignalsTest, AReleasedSignalIsNotReadAndTheFileCanBeReadAgain) {
  WriteRun(file_);
  See(0, 2);
  Subscribe(kTimeSignal);
  ASSERT_TRUE(Eventually([this] { return Covers(kTimeSignal, 0, 2); }));
  signals_.release(RecordedPath(file_, kTimeSignal));
  signals_.follow();
  samples_.clear();
  QSignalSpy opened(&signals_, &RecordedSignals::opened);

  Subscribe(kWaveSignal);

  ASSERT_TRUE(Eventually([this] { return Covers(kWaveSignal, 0, 2); }));
  EXPECT_EQ(opened.count(), 1);
  EXPECT_TRUE(samples_[kTimeSignal].empty());
}

TEST_F(RecordedSignalsTest, AFileIsClosedAndOpenedAgainWhileTheDiskDoesNotRespond) {
  WriteRun(file_);
  See(0, 2);
  StoppableDisk disk;
  RecordedSignals signals_of_disk([this](const QString&) { return std::optional(seen_); },
                                  disk.opener());
  QSignalSpy opened(&signals_of_disk, &RecordedSignals::opened);
  const QString signal = RecordedPath(file_, kTimeSignal);
  disk.stop();
  signals_of_disk.subscribe(signal);
  ASSERT_TRUE(Eventually([&] { return disk.counts().waiting == 1; }));

  testing::internal::CaptureStderr();
  signals_of_disk.release(signal);
  signals_of_disk.follow();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "it waited for the reading";
  signals_of_disk.subscribe(signal);

  ASSERT_TRUE(Eventually([&] { return disk.counts().waiting == 2; }));
  disk.go();
  ASSERT_TRUE(Eventually([&] { return disk.counts().open_files == 1 && opened.count() > 0; }));
  EXPECT_EQ(opened.count(), 1);
}

}  // namespace
}  // namespace tendon::gui
