#include <gcm_gui/connect/connect_mode.h>
#include <gtest/gtest.h>
#include <tendon/payload/fingerprint.h>

#include <QSignalSpy>

#include "support/fakes.h"
#include "support/sample_system.h"

namespace tendon::gui {
namespace {

const InterfaceName kRobot{"desk", "teleoperation", "Robot"};
const InterfaceName kControl{"robot", "controller", "Control"};

class ConnectModeTest : public ::testing::Test {
 protected:
  ConnectModeTest() { Show(); }

  void Show() { store_.apply(system_.TakeChanges()); }

  SystemBuilder system_ = LookSystem(0);
  CatalogueStore store_;
  RecordingActions actions_;
  ConnectMode mode_{store_, actions_};
};

TEST_F(ConnectModeTest, NumbersCompatibleCandidatesFirst) {
  ASSERT_TRUE(mode_.start({Side::kRequired, kRobot}));

  ASSERT_NE(mode_.best(), nullptr);
  EXPECT_EQ(mode_.best()->port.name, kControl);
  EXPECT_EQ(mode_.best()->number, 1);
  const PortCandidate* drives = mode_.find({Side::kProvided, {"robot", "arm", "Drives"}});
  ASSERT_NE(drives, nullptr);
  EXPECT_FALSE(drives->fits());
  EXPECT_EQ(drives->number, 0);
}

TEST_F(ConnectModeTest, ExplainsWhyALookAlikeDoesNotFit) {
  mode_.start({Side::kRequired, kRobot});

  const PortCandidate* drives = mode_.bestLookAlike();
  ASSERT_NE(drives, nullptr);
  EXPECT_EQ(drives->port.name, (InterfaceName{"robot", "arm", "Drives"}));
  EXPECT_EQ(drives->reasons(), QStringList{"missing write command 'MoveTo' of arm.JointGoal"});
}

TEST_F(ConnectModeTest, ExplainsATypeDifferenceOnceTheTypesAreKnown) {
  const Schema radians = Schema::Structure("arm.Q", {{"q", "rad", Schema(Schema::Kind::kFloat64)}});
  const Schema degrees = Schema::Structure("arm.Q", {{"q", "deg", Schema(Schema::Kind::kFloat64)}});
  MemberDescription needed = Read("GetQ", "arm.Q");
  needed.signature.out = radians.fingerprint();
  MemberDescription offered = needed;
  offered.signature.out = degrees.fingerprint();
  ComponentDescription client = Task("client", 0, {});
  client.required.push_back({"Arm", {needed}, {}, false});
  ComponentDescription server = Task("server", 0, {});
  server.provided.push_back({"Arm", {offered}, {}});
  system_.Component("desk", client).Component("desk", server);
  Show();

  mode_.start({Side::kRequired, {"desk", "client", "Arm"}});
  EXPECT_FALSE(mode_.bestLookAlike()->reasons().front().contains("deg"));
  payload::Remember(radians);
  payload::Remember(degrees);
  Q_EMIT store_.typesLearned();

  const QString reason = mode_.bestLookAlike()->reasons().front();
  EXPECT_TRUE(reason.contains("rad") && reason.contains("deg")) << qPrintable(reason);
}

TEST_F(ConnectModeTest, ADigitConnectsAndLeavesTheMode) {
  QSignalSpy picked(&mode_, &ConnectMode::picked);
  mode_.start({Side::kRequired, kRobot});

  mode_.pickNumber(1);

  EXPECT_EQ(actions_.asked,
            QStringList{"connect desk/teleoperation/Robot robot/controller/Control"});
  EXPECT_FALSE(mode_.active());
  EXPECT_EQ(picked.count(), 1);
}

TEST_F(ConnectModeTest, StartsFromTheProvidedEnd) {
  mode_.start({Side::kProvided, kControl});
  mode_.pickBest();

  EXPECT_EQ(actions_.asked,
            QStringList{"connect desk/teleoperation/Robot robot/controller/Control"});
}

TEST_F(ConnectModeTest, AConnectedInterfaceCanBeReconnected) {
  ComponentDescription spare = *system_.catalogue().FindComponent("robot", "arm");
  spare.name = "spare";
  system_.Component("robot", spare);
  Show();

  ASSERT_TRUE(mode_.start({Side::kRequired, {"robot", "controller", "Arm"}}));
  EXPECT_EQ(mode_.former(), (InterfaceName{"robot", "arm", "Drives"}));
  mode_.pickBest();

  EXPECT_EQ(actions_.asked, QStringList{"connect robot/controller/Arm robot/spare/Drives"});
}

TEST_F(ConnectModeTest, TheCurrentPeerIsNoCandidate) {
  mode_.start({Side::kProvided, {"robot", "arm", "Drives"}});

  const PortCandidate* arm = mode_.find({Side::kRequired, {"robot", "controller", "Arm"}});
  ASSERT_NE(arm, nullptr);
  EXPECT_TRUE(arm->present);
  EXPECT_FALSE(arm->fits());
  EXPECT_EQ(arm->reasons(), QStringList{"is the current connection"});
}

TEST_F(ConnectModeTest, ListsConnectedInterfacesAfterFreeOnes) {
  ComponentDescription spare = *system_.catalogue().FindComponent("robot", "arm");
  spare.name = "spare";
  ComponentDescription free = *system_.catalogue().FindComponent("robot", "controller");
  free.name = "second";
  system_.Component("robot", spare).Component("robot", free);
  Show();

  mode_.start({Side::kProvided, {"robot", "spare", "Drives"}});

  EXPECT_EQ(mode_.candidates()[0].port.name, (InterfaceName{"robot", "second", "Arm"}));
  EXPECT_EQ(mode_.candidates()[1].former, (InterfaceName{"robot", "arm", "Drives"}));
  mode_.pickNumber(2);
  EXPECT_EQ(actions_.asked, QStringList{"connect robot/controller/Arm robot/spare/Drives"});
}

TEST_F(ConnectModeTest, PickingAMismatchGivesTheReason) {
  QSignalSpy notice(&mode_, &ConnectMode::notice);
  QSignalSpy misfit(&mode_, &ConnectMode::mismatchPicked);
  const InterfaceName drives{"robot", "arm", "Drives"};
  mode_.start({Side::kRequired, kRobot});

  mode_.pick({Side::kProvided, drives});

  EXPECT_TRUE(actions_.asked.isEmpty());
  EXPECT_TRUE(mode_.active());
  ASSERT_EQ(notice.count(), 1);
  EXPECT_TRUE(notice.front().front().toString().contains("MoveTo"));
  ASSERT_EQ(misfit.count(), 1);
  EXPECT_EQ(misfit.front().front().value<message::ConnectionEnds>(),
            (message::ConnectionEnds{kRobot, drives}));
  EXPECT_EQ(misfit.front().back(), notice.front().front());
}

TEST_F(ConnectModeTest, EndsWhenItsPortIsRemovedOrReconnected) {
  mode_.start({Side::kRequired, kRobot});
  system_.Connect(kRobot, kControl);
  Show();
  EXPECT_FALSE(mode_.active());

  mode_.start({Side::kRequired, kRobot});
  system_.Disconnect(kRobot);
  Show();
  EXPECT_FALSE(mode_.active());

  mode_.start({Side::kProvided, kControl});
  system_.RemoveComponent("robot", "controller");
  Show();
  EXPECT_FALSE(mode_.active());
}

TEST_F(ConnectModeTest, FollowsCatalogueChanges) {
  mode_.start({Side::kRequired, kRobot});
  ComponentDescription other = *system_.catalogue().FindComponent("robot", "controller");
  other.name = "backup";
  system_.Component("robot", other);
  Show();

  EXPECT_NE(mode_.find({Side::kProvided, {"robot", "backup", "Control"}}), nullptr);
  EXPECT_EQ(mode_.candidates()[1].number, 2);
}

TEST_F(ConnectModeTest, ListsLostProvidersLast) {
  ComponentDescription other = *system_.catalogue().FindComponent("robot", "controller");
  system_.Process("away").Component("away", other).Process("away", ProcessState::kLost, 1);
  Show();

  mode_.start({Side::kRequired, kRobot});

  EXPECT_EQ(mode_.best()->port.name.process, "robot");
  EXPECT_EQ(mode_.candidates()[1].port.name.process, "away");
  EXPECT_TRUE(mode_.candidates()[1].gone);
}

}  // namespace
}  // namespace tendon::gui
