#include <gcm_gui/models/catalogue_model.h>
#include <gcm_gui/models/row_roles.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <chrono>

#include "support/fakes.h"
#include "support/sample_system.h"

namespace tendon::gui {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr auto kJoints = "robot/arm/state.Joints";
constexpr auto kFirstJoint = "robot/arm/state.Joints.position[0]";

/// Tests the columns of the catalogue after name and value.
class CatalogueFactsTest : public ::testing::Test {
 protected:
  CatalogueFactsTest() {
    QObject::connect(&store_, &CatalogueStore::changed, &model_, &CatalogueModel::update);
    store_.apply(system_.TakeChanges());
    shape_ =
        std::make_shared<const std::vector<NumericField>>(NumericFields(test::JointStateSchema(1)));
  }

  QString Text(const QString& path, int column) const {
    return model_.indexOf(path).siblingAtColumn(column).data().toString();
  }
  QString Rate(const QString& path) const { return Text(path, CatalogueModel::kRate); }
  QString Age(const QString& path) const { return Text(path, CatalogueModel::kAge); }
  QString Connected(const QString& path) const { return Text(path, CatalogueModel::kConnected); }
  QString Spoken(const QString& path, int column) const {
    const QModelIndex index = model_.indexOf(path).siblingAtColumn(column);
    return index.data(Qt::AccessibleTextRole).toString();
  }

  /// Sends rows at 100 Hz for this time. Every 0.1 s, the model receives the newest row.
  void Stream(seconds how_long) {
    for (int i = 0; i < 10 * how_long.count(); ++i) {
      clock_.Advance(milliseconds(100));
      rows_ += 10;
      model_.showValues(kJoints, {.fields = shape_,
                                  .values = ExactValues({1, 2}),
                                  .text = {},
                                  .rows = rows_,
                                  .time = clock_.Now().time_since_epoch().count()});
    }
  }

  ManualClock clock_;
  SystemBuilder system_ = LookSystem(0);
  CatalogueStore store_;
  CatalogueModel model_{nullptr, clock_};
  QAbstractItemModelTester tester_{&model_, QAbstractItemModelTester::FailureReportingMode::Fatal};
  NumericFieldList shape_;
  std::uint64_t rows_ = 0;
};

TEST_F(CatalogueFactsTest, ShowsPeersAtBothEndsOfAConnection) {
  EXPECT_EQ(Connected("robot/controller/Arm"), "arm/Drives");
  EXPECT_EQ(Connected("robot/arm/Drives"), "controller/Arm");
  EXPECT_EQ(Connected("robot/controller"), "arm, force_sensor");
  EXPECT_EQ(Connected("desk/teleoperation/Robot"), "nothing");
}

TEST_F(CatalogueFactsTest, ShowsADashForUnknownFacts) {
  for (const QString path : {kJoints, "robot/arm", "robot/arm/Drives.SetTorques"}) {
    EXPECT_EQ(Rate(path), "–") << qPrintable(path);
    EXPECT_EQ(Age(path), "–") << qPrintable(path);
  }
  EXPECT_EQ(Connected(kJoints), "–");
  EXPECT_EQ(Spoken(kJoints, CatalogueModel::kRate), "Rate: not known");
}

TEST_F(CatalogueFactsTest, MeasuresRateAndAgeFromArrivingRows) {
  Stream(seconds(3));

  EXPECT_EQ(Rate(kJoints), "100 Hz");
  EXPECT_EQ(Rate(kFirstJoint), "100 Hz");
  EXPECT_EQ(Rate("robot/arm"), "100 Hz") << "of the fastest of its columns";
  EXPECT_EQ(Rate("robot/arm/state.Cycle"), "–");
  EXPECT_EQ(Age(kFirstJoint), "0 s");
  EXPECT_EQ(Spoken(kJoints, CatalogueModel::kRate), "Rate: 100 Hz");
}

TEST_F(CatalogueFactsTest, AWatchedSilentColumnAges) {
  model_.setWatched({kJoints});
  Stream(seconds(3));

  clock_.Advance(seconds(12));

  EXPECT_EQ(Age(kFirstJoint), "12 s");
  EXPECT_EQ(Rate(kFirstJoint), "–") << "nothing comes any more";
}

TEST_F(CatalogueFactsTest, AnUnwatchedColumnHasNoRateOrAge) {
  model_.setWatched({kJoints});
  Stream(seconds(3));

  model_.setWatched({});
  clock_.Advance(seconds(12));

  EXPECT_EQ(Age(kFirstJoint), "–");
  EXPECT_EQ(Rate(kFirstJoint), "–");
  rows_ = 0;
  Stream(seconds(1));
  EXPECT_EQ(Rate(kFirstJoint), "–") << "it is not yet measured";
  Stream(seconds(1));
  EXPECT_EQ(Rate(kFirstJoint), "100 Hz");
}

TEST_F(CatalogueFactsTest, ValuesOfALostProcessAge) {
  model_.setWatched({kJoints});
  Stream(seconds(3));
  system_.Process("robot", ProcessState::kLost);
  store_.apply(system_.TakeChanges());
  clock_.Advance(seconds(12));

  EXPECT_EQ(Age(kFirstJoint), "12 s");
  EXPECT_EQ(Rate(kFirstJoint), "–");
  EXPECT_EQ(model_.indexOf(kJoints).data(kDetailRole), "lost · 12 s old");
}

TEST_F(CatalogueFactsTest, MarksValuesOfASuspendedComponentWithTheirAge) {
  Stream(seconds(3));
  EXPECT_FALSE(model_.indexOf(kFirstJoint).data(kStaleRole).toBool());
  ComponentDescription arm = *system_.catalogue().FindComponent("robot", "arm");
  arm.state = ComponentState::kSuspended;
  system_.Component("robot", arm);
  store_.apply(system_.TakeChanges());

  clock_.Advance(seconds(12));

  for (const QString path : {kJoints, kFirstJoint}) {
    EXPECT_TRUE(model_.indexOf(path).data(kStaleRole).toBool()) << qPrintable(path);
    EXPECT_EQ(Age(path), "12 s");
    EXPECT_EQ(Rate(path), "–");
    EXPECT_TRUE(Spoken(path, CatalogueModel::kValue).endsWith(", suspended · 12 s old"));
  }
  EXPECT_EQ(model_.indexOf(kJoints).data(kDetailRole), "suspended · 12 s old");
  EXPECT_EQ(model_.standstill(kFirstJoint), StaleReason::kSuspended);
  EXPECT_FALSE(model_.indexOf("robot/arm/state.Cycle").data(kStaleRole).toBool())
      << "there is no value of it";
}

TEST_F(CatalogueFactsTest, TheAgeOfAProcessIsTheAgeOfItsState) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  system_.Process("robot", ProcessState::kAlive, 100 * kSecond);
  store_.apply(system_.TakeChanges());

  model_.setNow(160 * kSecond);

  EXPECT_EQ(Age("robot"), "60 s");
}

}  // namespace
}  // namespace tendon::gui
