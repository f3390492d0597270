#include <gcm_gui/replay/replay_reader.h>
#include <gmock/gmock.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <functional>
#include <memory>
#include <vector>

#include "replay/recorded_file.h"
#include "replay/stoppable_disk.h"

namespace tendon::gui {
namespace {

using testing::ElementsAre;

constexpr int kReaderTimeout = 120'000;  // ms; bounds a test that fails
constexpr auto kColumn = "robot/arm/state.Joints";
constexpr auto kOtherColumn = "robot/arm/state.Temperature";
constexpr auto kField = ".position[0]";

/// A reader of a recording, without a window.
class ReplayReading : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(folder_.isValid());
    file_ = folder_.filePath("run.mcap");
  }
  void Open() {
    QSignalSpy opened(&reader_, &ReplayReader::opened);
    reader_.open(file_);
    ASSERT_TRUE(opened.wait(kReaderTimeout));
  }
  /// A feed that keeps position[0].
  static std::shared_ptr<ColumnFeed> Feed() {
    auto feed = std::make_shared<ColumnFeed>();
    feed->tap(kField);
    return feed;
  }
  void Jump(std::int64_t time, const WantedColumns& columns) {
    QSignalSpy stepped(&reader_, &ReplayReader::stepped);
    reader_.jump(time, 20 * kSecond, columns);
    ASSERT_TRUE(stepped.wait(kReaderTimeout));
  }

  static bool Eventually(const std::function<bool()>& holds) {
    return QTest::qWaitFor(holds, kReaderTimeout);
  }

  QTemporaryDir folder_;
  QString file_;
  ReplayReader reader_;
};

TEST_F(ReplayReading, EachRunOfAColumnIsReadWithTheTypeThatItHadThen) {
  WriteTwoTypes(file_);
  Open();
  const auto feed = Feed();

  Jump(kRunBegin + kSecond, {{kColumn, {feed, true}}});

  std::vector<double> values;
  for (const auto& run : feed->take(kField).runs) {
    for (const Sample& sample : run.samples) values.push_back(sample.value.nearest());
  }
  EXPECT_THAT(values, ElementsAre(1, 1, 1, 1, 1, 3, 3, 3, 3, 3));
}

TEST_F(ReplayReading, EachLossIsCountedOnce) {
  WriteRun(file_);
  Open();
  const auto plotted = Feed();
  const auto shown = Feed();

  // The loss of 50 rows is in the table of both columns, at the moment itself.
  Jump(kRunBegin + kSecond * 105 / 10,
       {{kColumn, {plotted, true}}, {kOtherColumn, {shown, false}}});
  QSignalSpy stepped(&reader_, &ReplayReader::stepped);
  reader_.add(kOtherColumn, shown);
  ASSERT_TRUE(stepped.wait(kReaderTimeout));

  EXPECT_EQ(plotted->losses().table, 50U);
}

TEST_F(ReplayReading, OnlyRowsAreReadForAPlotOfAnotherSystem) {
  WriteRun(file_);
  ReplayReader rows(ReplayReader::Content::kRows);
  QSignalSpy opened(&rows, &ReplayReader::opened);
  QSignalSpy stepped(&rows, &ReplayReader::stepped);
  rows.open(file_);
  ASSERT_TRUE(opened.wait(kReaderTimeout));
  const auto facts = opened[0][0].value<RecordingFacts>();
  EXPECT_EQ(facts.columns.size(), 2U);
  EXPECT_EQ(facts.columns.count(kColumn), 1U);

  const auto feed = Feed();
  rows.jump(kRunBegin + 6 * kSecond, kSecond, {{kColumn, {feed, true}}});
  ASSERT_TRUE(stepped.wait(kReaderTimeout));
  rows.play(kRunBegin + 17 * kSecond);
  ASSERT_TRUE(stepped.wait(kReaderTimeout));

  for (const QList<QVariant>& arguments : stepped) {
    const auto step = arguments[0].value<ReplayStep>();
    EXPECT_TRUE(step.events.empty());
    EXPECT_TRUE(step.log.records.empty());
    EXPECT_FALSE(step.catalogue);
    EXPECT_TRUE(step.changes.empty());
    EXPECT_FALSE(step.is_gone);
  }
  EXPECT_EQ(feed->losses().table, 50U);
  EXPECT_FALSE(feed->take(kField).runs.empty());
}

TEST_F(ReplayReading, TheDestructorDoesNotWaitForTheDisk) {
  WriteRun(file_);
  StoppableDisk disk;
  disk.stop();
  auto reader = std::make_unique<ReplayReader>(ReplayReader::Content::kAll, disk.opener());
  reader->open(file_);
  ASSERT_TRUE(Eventually([&] { return disk.counts().waiting == 1; }));

  testing::internal::CaptureStderr();
  reader.reset();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "it gave up a reading";

  EXPECT_EQ(disk.counts().waiting, 1);
}

TEST_F(ReplayReading, ACancelledReadingReadsNoFurtherAndDropsItsRows) {
  WriteRun(file_);
  StoppableDisk disk;
  auto reader = std::make_unique<ReplayReader>(ReplayReader::Content::kRows, disk.opener());
  QSignalSpy opened(reader.get(), &ReplayReader::opened);
  reader->open(file_);
  ASSERT_TRUE(opened.wait(kReaderTimeout));
  const auto feed = Feed();
  disk.stop();
  reader->jump(kRunBegin + 20 * kSecond, 20 * kSecond, {{kColumn, {feed, true}}});
  ASSERT_TRUE(Eventually([&] { return disk.counts().waiting == 1; }));
  const int reads = disk.counts().reads;

  reader.reset();
  disk.go();

  ASSERT_TRUE(Eventually([&] { return disk.counts().open_files == 0; }));
  EXPECT_EQ(disk.counts().reads, reads);
  EXPECT_TRUE(feed->take(kField).runs.empty());
}

TEST_F(ReplayReading, TheDestructorDoesNotWaitUntilTheFileIsClosed) {
  WriteRun(file_);
  StoppableDisk disk;
  auto reader = std::make_unique<ReplayReader>(ReplayReader::Content::kAll, disk.opener());
  QSignalSpy opened(reader.get(), &ReplayReader::opened);
  reader->open(file_);
  ASSERT_TRUE(opened.wait(kReaderTimeout));
  disk.stop();

  reader.reset();

  EXPECT_EQ(disk.counts().open_files, 1);
  disk.go();
  EXPECT_TRUE(Eventually([&] { return disk.counts().open_files == 0; }));
}

}  // namespace
}  // namespace tendon::gui
