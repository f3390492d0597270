#include <gmock/gmock.h>
#include <tests/core/gcm/gcm_fixture.h>

#include <atomic>
#include <thread>

namespace tendon {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using test::FakeProcess;
using test::kControl;
using test::kRobot;
using Manners = FakeProcess::Manners;

const InterfaceName kSecond("robot", "second", "Control");
const InterfaceName kSpare("spare", "arm", "Control");

class Replacing : public test::DeskAndRobot {
 protected:
  void SetUp() override {
    DeskAndRobot::SetUp();
    robot_->Add(test::Arm("second"));
    ASSERT_TRUE(EventuallyTrue([&] { return gcm_->catalogue().FindProvided(kSecond) != nullptr; }));
  }

  static Result<ConnectionDescription> Replace(GcmClient& client, const InterfaceName& provided) {
    return Wait<ConnectionDescription>(kLong, [&](auto handler) {
      client.Connect(kRobot, provided, handler, WhenConnected::kReplace);
    });
  }
  [[nodiscard]] bool IsConnectedTo(const InterfaceName& provided) const {
    const auto connection = Connection();
    return connection && connection->provided == provided &&
           connection->state == ConnectionState::kActive;
  }
};

INSTANTIATE_TEST_SUITE_P(Over, Replacing, testing::Values("loopback", "tcp"),
                         test::NameOfParameter);

TEST_P(Replacing, AReplacementIsOneStepAndOneUndo) {
  ASSERT_TRUE(Connect(*client_));

  const auto made = Replace(*client_, kSecond);

  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(Connection()->provided, kSecond);
  const auto steps = Steps(*client_);
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[1].verb, "replace");
  EXPECT_EQ(steps[1].ends, (message::ConnectionEnds{kRobot, kSecond}));
  EXPECT_EQ(steps[1].former, kControl);

  const auto undone = Undo(*client_);
  ASSERT_TRUE(undone) << undone.error().message;
  EXPECT_EQ(undone->verb, "replace");
  EXPECT_EQ(Connection()->provided, kControl);
  EXPECT_TRUE(Undo(*client_));
  EXPECT_FALSE(Connection());
}

TEST_P(Replacing, ReplacingNothingConnects) {
  ASSERT_TRUE(Replace(*client_, kControl));

  EXPECT_EQ(Steps(*client_)[0].verb, "connect");
  EXPECT_EQ(Replace(*client_, kControl).error().code, ErrorCode::kExists);
}

TEST_P(Replacing, AnIncompatibleProviderReplacesNothing) {
  ASSERT_TRUE(Connect(*client_));
  const auto before = Connection();

  EXPECT_EQ(Replace(*client_, {"robot", "fake", "Control"}).error().code, ErrorCode::kIncompatible);
  EXPECT_EQ(Replace(*client_, {"robot", "arn", "Control"}).error().code, ErrorCode::kNotFound);

  EXPECT_EQ(Connection(), before);
  EXPECT_EQ(Steps(*client_).size(), 1U);
}

TEST_P(Replacing, ARefusedReplacementKeepsTheConnection) {
  ASSERT_TRUE(Connect(*client_));
  desk_->set_manners(Manners::kRefuseTheNextConnect);

  const auto made = Replace(*client_, kSecond);

  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message,
            "teleoperation is busy; desk/teleoperation/Robot is still connected to "
            "robot/arm/Control");
  EXPECT_EQ(Connection()->provided, kControl);
  EXPECT_EQ(Steps(*client_).size(), 1U);
}

TEST_P(Replacing, AnAbsentProviderReplacesNoActiveConnection) {
  auto spare = Join("spare", {test::Arm()});
  ASSERT_TRUE(Connect(*client_));
  const auto before = Connection();

  EXPECT_EQ(
      Replace(*client_, {"robbot", "arm", "Control"}).error(),
      (Error{
          ErrorCode::kNotFound,
          "desk/teleoperation/Robot stays connected to robot/arm/Control, because the new provided "
          "interface must be available first: no process 'robbot'; did you mean 'robot'?"}));
  ASSERT_TRUE(spare->Leave());
  EXPECT_EQ(Replace(*client_, kSpare).error(),
            (Error{ErrorCode::kFailed,
                   "desk/teleoperation/Robot stays connected to robot/arm/Control, because the new "
                   "provided interface must be available first: process 'spare' has left "
                   "(deregistered); start it again first"}));

  EXPECT_EQ(Connection(), before);
  EXPECT_EQ(desk_->orders().size(), 1U);
  EXPECT_EQ(Steps(*client_).size(), 1U);
}

TEST_P(Replacing, APendingConnectionCanBeReplaced) {
  const InterfaceName never("never", "arm", "Control");
  ASSERT_TRUE(Connect(*client_, kRobot, never));

  ASSERT_TRUE(Replace(*client_, kSpare));

  EXPECT_EQ(Connection()->provided, kSpare);
  ASSERT_TRUE(Undo(*client_));
  EXPECT_EQ(Connection()->provided, never);
}

TEST_P(Replacing, AnUndoNeedingALostProcessKeepsTheConnection) {
  auto spare = Join("spare", {test::Arm()});
  ASSERT_TRUE(Connect(*client_, kRobot, kSpare));
  ASSERT_TRUE(Replace(*client_, kControl));
  ASSERT_TRUE(spare->Leave());

  const auto undone = Undo(*client_);

  ASSERT_FALSE(undone);
  EXPECT_THAT(
      undone.error().message,
      testing::HasSubstr("): desk/teleoperation/Robot stays connected to robot/arm/Control, "
                         "because the new provided interface must be available first: process "
                         "'spare' has left (deregistered); start it again first; "));
  EXPECT_TRUE(IsConnectedTo(kControl));
  EXPECT_FALSE(Steps(*client_).back().undone);
}

TEST_P(Replacing, AnUnreachableProviderReplacesNoConnection) {
  ASSERT_TRUE(Connect(*client_));
  desk_->set_manners(Manners::kMissTheNextProvider);

  const auto made = Replace(*client_, kSecond);

  ASSERT_FALSE(made);
  EXPECT_EQ(made.error(), (Error{ErrorCode::kUnreachable,
                                 "robot/second/Control was not reached: nobody answers; "
                                 "desk/teleoperation/Robot is still connected to "
                                 "robot/arm/Control"}));
  EXPECT_TRUE(IsConnectedTo(kControl));
  EXPECT_EQ(desk_->connection_count(), 1U);
  EXPECT_EQ(Steps(*client_).size(), 1U);
}

TEST_P(Replacing, AnUndoWithoutReachableProviderChangesNothing) {
  ASSERT_TRUE(Connect(*client_));
  ASSERT_TRUE(Replace(*client_, kSecond));
  desk_->set_manners(Manners::kMissTheNextProvider);

  EXPECT_FALSE(Undo(*client_));

  EXPECT_TRUE(IsConnectedTo(kSecond));
  EXPECT_TRUE(Undo(*client_));
  EXPECT_TRUE(IsConnectedTo(kControl));
}

TEST_P(Replacing, NoOtherConnectComesBetweenItsTwoHalves) {
  ASSERT_TRUE(Connect(*client_));
  const auto rival = Watch();
  std::atomic<bool> is_over = false;
  std::atomic<int> connects = 0;
  std::thread thread([&] {
    while (!is_over) {
      if (Connect(*rival)) ++connects;
    }
  });

  for (int i = 0; i < 50; ++i) {
    const auto made = Replace(*client_, i % 2 == 0 ? kSecond : kControl);
    EXPECT_TRUE(made) << made.error().message;
  }

  is_over = true;
  thread.join();
  EXPECT_EQ(connects, 0);
}

TEST_P(Replacing, AFailedRestoreIsRecordedAsADisconnect) {
  ASSERT_TRUE(Connect(*client_));
  desk_->set_manners(Manners::kRefuseConnects);

  const auto made = Replace(*client_, kSecond);

  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message,
            "teleoperation is busy; desk/teleoperation/Robot is not connected to robot/arm/Control "
            "any more, and this connection could not be made again: teleoperation is busy");
  EXPECT_FALSE(Connection());
  const auto steps = Steps(*client_);
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[1].verb, "disconnect");
  EXPECT_EQ(steps[1].ends, (message::ConnectionEnds{kRobot, kControl}));
  EXPECT_EQ(steps[1].who, "gcm connect");
  desk_->set_manners(Manners::kObey);
  EXPECT_TRUE(Undo(*client_));
  EXPECT_TRUE(IsConnectedTo(kControl));
}

TEST_P(Replacing, ALateProcessEndsWithTheFormerConnection) {
  ASSERT_TRUE(Connect(*client_));
  const auto before = Connection();
  order_timeout_ = 1s;
  RestartGcm();
  desk_->set_manners(Manners::kDelay);

  const auto made = Replace(*client_, kSecond);

  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::kTimeout);
  EXPECT_TRUE(made.error().message.ends_with(
      "; it is not known yet whether desk/teleoperation/Robot is still connected to "
      "robot/arm/Control; see: gcm show desk/teleoperation/Robot"))
      << made.error().message;
  EXPECT_EQ(Steps(*client_).size(), 1U);
  desk_->set_manners(Manners::kObey);
  EXPECT_TRUE(EventuallyTrue([&] { return IsConnectedTo(kControl) && Connection() != before; }));
  EXPECT_EQ(desk_->connection_count(), 1U);
}

TEST_P(Replacing, ARestoreByALateProcessCanBeUndone) {
  ASSERT_TRUE(Connect(*client_));
  const auto before = Connection();
  order_timeout_ = 1s;
  RestartGcm();
  desk_->set_manners(Manners::kDelayFromConnect);

  EXPECT_EQ(Replace(*client_, kSecond).error().code, ErrorCode::kTimeout);

  desk_->set_manners(Manners::kObey);
  EXPECT_TRUE(EventuallyTrue([&] { return IsConnectedTo(kControl) && Connection() != before; }));
  order_timeout_ = kLong;
  RestartGcm();
  while (Undo(*client_)) EXPECT_LE(Steps(*client_).size(), 2U);
  EXPECT_FALSE(Connection());
  for (const auto& step : Steps(*client_)) EXPECT_TRUE(step.undone) << step.verb;
}

TEST_P(Replacing, WithoutAReplyTheReportDecides) {
  ASSERT_TRUE(Connect(*client_));
  desk_->set_manners(Manners::kObeyAndDie);

  const auto made = Replace(*client_, kSecond);

  ASSERT_FALSE(made);  // the process has broken the former connection and then ended
  const auto steps = Steps(*client_);
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[1].verb, "disconnect");
}

}  // namespace
}  // namespace tendon
