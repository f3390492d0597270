#include <gcm_gui/activity/log_filter.h>
#include <gcm_gui/activity/log_model.h>
#include <gcm_gui/models/row_roles.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <string>

namespace tendon::gui {
namespace {

class LogModelTest : public ::testing::Test {
 protected:
  void Hear(LogLevel level, const std::string& source, const std::string& text) {
    LogBatch batch;
    batch.records.push_back({1, level, "robot", source, text});
    model_.add(batch);
  }
  QStringList Shown() const {
    QStringList texts;
    for (int row = 0; row < filter_.rowCount(); ++row) {
      texts << filter_.index(row, 0).data().toString();
    }
    return texts;
  }

  LogModel model_;
  LogFilter filter_{model_};
  QAbstractItemModelTester model_tester_{&model_};
  QAbstractItemModelTester filter_tester_{&filter_};
};

TEST_F(LogModelTest, ARecordNamesItsSource) {
  Hear(LogLevel::kInfo, "robot", "joined");
  Hear(LogLevel::kWarning, "arm", "missed a cycle");

  EXPECT_EQ(model_.index(0).data(kPathRole).toString(), "robot");
  EXPECT_EQ(model_.index(1).data(kPathRole).toString(), "robot/arm");
  EXPECT_EQ(model_.index(1).data(Qt::AccessibleTextRole).toString(),
            "warning robot/arm: missed a cycle");
}

TEST_F(LogModelTest, DropsTheOldestRecords) {
  LogBatch batch;
  batch.records.resize(LogModel::kKept);
  model_.add(batch);
  Hear(LogLevel::kInfo, "arm", "newest");

  EXPECT_EQ(model_.rowCount(), static_cast<int>(LogModel::kKept));
  EXPECT_EQ(model_.index(model_.rowCount() - 1).data().toString(), "newest");
}

TEST_F(LogModelTest, CountsRecordsThatTheGcmDropped) {
  LogBatch batch;
  batch.lost = 7;
  model_.add(batch);

  EXPECT_EQ(model_.lost(), 7U);
}

TEST_F(LogModelTest, ALevelHidesLowerRecords) {
  Hear(LogLevel::kDebug, "arm", "detail");
  Hear(LogLevel::kError, "arm", "broken");

  filter_.setLevel(LogLevel::kWarning);

  EXPECT_EQ(Shown(), QStringList{"broken"});
}

TEST_F(LogModelTest, TheFilterNeedsEveryWordInSourceOrText) {
  Hear(LogLevel::kInfo, "arm", "Joined the GCM");
  Hear(LogLevel::kInfo, "camera", "joined the arm");

  filter_.setText("joined arm");
  EXPECT_EQ(Shown().size(), 2);
  filter_.setText("joined from:arm");
  EXPECT_EQ(Shown(), QStringList{"Joined the GCM"});
  filter_.setText("joined -camera");
  EXPECT_EQ(Shown(), QStringList{"Joined the GCM"});
}

}  // namespace
}  // namespace tendon::gui
