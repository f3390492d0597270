#include <gcm_gui/connect/candidates_model.h>
#include <gcm_gui/models/row_roles.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <string>

#include "support/fakes.h"
#include "support/sample_system.h"

namespace tendon::gui {
namespace {

const PortName kRobotPort{Side::kRequired, {"desk", "teleoperation", "Robot"}};
const PortName kControlPort{Side::kProvided, {"robot", "controller", "Control"}};
const PortName kDrivesPort{Side::kProvided, {"robot", "arm", "Drives"}};

class CandidatesModelTest : public ::testing::Test {
 protected:
  CandidatesModelTest() { store_.apply(system_.TakeChanges()); }

  QModelIndex Row(int row) const { return model_.index(row, 0, {}); }
  QString Name(int row) const { return Row(row).data().toString(); }

  SystemBuilder system_ = LookSystem(0);
  CatalogueStore store_;
  RecordingActions actions_;
  ConnectMode mode_{store_, actions_};
  CandidatesModel model_{mode_};
  QAbstractItemModelTester tester_{&model_, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(CandidatesModelTest, IsEmptyUntilAPortIsChosen) {
  EXPECT_EQ(model_.rowCount({}), 0);

  mode_.start(kRobotPort);
  EXPECT_GT(model_.rowCount({}), 0);

  mode_.leave();
  EXPECT_EQ(model_.rowCount({}), 0);
}

TEST_F(CandidatesModelTest, ListsCompatibleInterfacesFirstWithTheirDigits) {
  mode_.start(kRobotPort);

  EXPECT_EQ(Name(0), "robot/controller/Control");
  EXPECT_EQ(Row(0).data(kGlyphRole).toString(), "1");
  EXPECT_EQ(Row(0).data(kTrailRole).toString(), "2 of 2");
  EXPECT_TRUE(model_.fits(Row(0)));
  EXPECT_EQ(model_.portOf(Row(0)), kControlPort);
  EXPECT_EQ(model_.rowCount(Row(0)), 0);
}

TEST_F(CandidatesModelTest, ListsReasonsBelowANearMiss) {
  mode_.start(kRobotPort);

  EXPECT_EQ(Name(1), "robot/arm/Drives");
  EXPECT_FALSE(model_.fits(Row(1)));
  ASSERT_EQ(model_.rowCount(Row(1)), 1);
  const QModelIndex reason = model_.index(0, 0, Row(1));
  EXPECT_EQ(reason.data().toString(), "missing write command 'MoveTo' of arm.JointGoal");
  EXPECT_EQ(model_.portOf(reason), kDrivesPort);
}

TEST_F(CandidatesModelTest, OnlyCountsUnrelatedInterfaces) {
  mode_.start(kRobotPort);

  const QModelIndex last = Row(model_.rowCount({}) - 1);
  EXPECT_TRUE(last.data().toString().endsWith(" more do not fit"))
      << last.data().toString().toStdString();
  EXPECT_FALSE(model_.portOf(last).has_value());
}

TEST_F(CandidatesModelTest, LimitsTheListAndFindsTheRestByFilter) {
  const ComponentDescription arm = *system_.catalogue().FindComponent("robot", "controller");
  constexpr int kCount = 2 * static_cast<int>(CandidatesModel::kMaxShown);
  for (int i = 0; i < kCount; ++i) {
    ComponentDescription copy = arm;
    copy.name = "copy_" + std::to_string(1000 + i);
    system_.Component("robot", copy);
  }
  store_.apply(system_.TakeChanges());
  mode_.start(kRobotPort);

  const int rest = static_cast<int>(CandidatesModel::kMaxShown);
  EXPECT_TRUE(Name(rest).endsWith(" more: type a part of the name to find one"))
      << Name(rest).toStdString();
  model_.setFilter("copy_1190/control");
  EXPECT_EQ(Name(0), "robot/copy_1190/Control");
  EXPECT_TRUE(model_.fits(Row(0)));
}

TEST_F(CandidatesModelTest, AFilterListsUnrelatedInterfaces) {
  mode_.start(kRobotPort);

  model_.setFilter("wrench force");

  ASSERT_EQ(model_.rowCount({}), 1);
  EXPECT_EQ(Name(0), "robot/force_sensor/Wrench");
}

TEST_F(CandidatesModelTest, TheCurrentPeerCannotBePicked) {
  mode_.start({Side::kRequired, {"robot", "controller", "Arm"}});

  EXPECT_EQ(Name(0), "robot/arm/Drives");
  EXPECT_EQ(Row(0).data(kTrailRole).toString(), "connected");
  EXPECT_FALSE(model_.fits(Row(0)));
}

}  // namespace
}  // namespace tendon::gui
