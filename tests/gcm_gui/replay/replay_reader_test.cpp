#include <gcm_gui/replay/replay_reader.h>
#include <gmock/gmock.h>

#include <QSignalSpy>
#include <QTemporaryDir>
#include <memory>
#include <vector>

#include "replay/recorded_file.h"

namespace tendon::gui {
namespace {

using testing::ElementsAre;

constexpr int kReaderPatience = 60000;  // ms; bounds a test that fails
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
    ASSERT_TRUE(opened.wait(kReaderPatience));
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
    ASSERT_TRUE(stepped.wait(kReaderPatience));
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
  ASSERT_TRUE(stepped.wait(kReaderPatience));

  EXPECT_EQ(plotted->losses().table, 50U);
}

}  // namespace
}  // namespace tendon::gui
