#include <gmock/gmock.h>
#include <tests/core/gcm/gcm_fixture.h>

#include <random>

namespace tendon {
namespace {

using test::kControl;
using test::kRobot;
using testing::HasSubstr;

class UndoOrders : public test::DeskAndRobot {
 protected:
  Result<message::HistoryEntry> SkipNewestStep() {
    return Wait<message::HistoryEntry>(kLong,
                                       [&](auto handler) { client_->SkipNewestStep(handler); });
  }
  Result<ConnectionDescription> Replace(const InterfaceName& required,
                                        const InterfaceName& provided) {
    return Wait<ConnectionDescription>(kLong, [&](auto handler) {
      client_->Connect(required, provided, handler, WhenConnected::kReplace);
    });
  }
  void WaitUntilGone(const std::string& process, const std::string& component) {
    ASSERT_TRUE(EventuallyTrue(
        [&] { return gcm_->catalogue().FindComponent(process, component) == nullptr; }));
  }
  /// Returns the message of an undo that must fail. The undo changes nothing.
  std::string WhyNot() {
    const auto undone = Undo(*client_);
    EXPECT_FALSE(undone);
    return undone ? "undone" : undone.error().message;
  }

  static constexpr const char* kNext =
      "to skip this step and undo the step before it: gcm undo --skip";
};

INSTANTIATE_TEST_SUITE_P(Over, UndoOrders, testing::Values("loopback", "tcp"),
                         test::NameOfParameter);

TEST_P(UndoOrders, NamesTheStepThatCannotBeUndoneAndTheRemedy) {
  ASSERT_TRUE(Connect(*client_));
  desk_->Remove("teleoperation");
  WaitUntilGone("desk", "teleoperation");

  const std::string why = WhyNot();

  EXPECT_TRUE(
      why.starts_with("cannot undo step 1 (connect desk/teleoperation/Robot "
                      "robot/arm/Control, by gcm connect at "))
      << why;
  EXPECT_THAT(why, HasSubstr("): no component 'desk/teleoperation'; there is none; "));
  EXPECT_TRUE(why.ends_with(kNext)) << why;
}

TEST_P(UndoOrders, SkipsAStepOfRemovedObjects) {
  const auto aide = Join("aide", {test::Teleoperation("helper")});
  ASSERT_TRUE(Connect(*client_));
  ASSERT_TRUE(Connect(*client_, {"aide", "helper", "Robot"}));
  aide->Remove("helper");
  WaitUntilGone("aide", "helper");
  EXPECT_THAT(WhyNot(), HasSubstr("step 2"));

  const auto passed = SkipNewestStep();

  ASSERT_TRUE(passed) << passed.error().message;
  EXPECT_EQ(passed->id, 2U);
  EXPECT_TRUE(passed->passed_over);
  const auto undone = Undo(*client_);
  ASSERT_TRUE(undone) << undone.error().message;
  EXPECT_EQ(undone->id, 1U);
  EXPECT_FALSE(Connection());
  RestartGcm();
  EXPECT_TRUE(Steps(*client_)[1].passed_over);
  EXPECT_FALSE(Steps(*client_)[1].undone);
  EXPECT_EQ(WhyNot(), "there is nothing to undo");
}

TEST_P(UndoOrders, RefusesToSkipAnUndoableStep) {
  EXPECT_EQ(SkipNewestStep().error().message, "there is nothing to undo");
  ASSERT_TRUE(Connect(*client_));

  const auto passed = SkipNewestStep();

  ASSERT_FALSE(passed);
  EXPECT_THAT(passed.error().message, HasSubstr(" can be undone, so it is not skipped"));
  EXPECT_TRUE(Undo(*client_));
}

TEST_P(UndoOrders, SkipsANamedStepEvenIfUndoable) {
  ASSERT_TRUE(Connect(*client_));

  const auto passed = Wait<message::HistoryEntry>(
      kLong, [&](auto handler) { client_->SkipNewestStep(handler, 1); });

  ASSERT_TRUE(passed) << passed.error().message;
  EXPECT_EQ(WhyNot(), "there is nothing to undo");
  EXPECT_TRUE(Connection());
}

TEST_P(UndoOrders, UndoesNothingInARestartedProcess) {
  ASSERT_TRUE(Connect(*client_));
  ASSERT_TRUE(Disconnect(*client_));
  desk_.reset();
  ASSERT_TRUE(EventuallyTrue([&] { return StateOf("desk") == ProcessState::kLost; }));
  EXPECT_THAT(WhyNot(), HasSubstr("): process 'desk' is lost"));
  EXPECT_THAT(SkipNewestStep().error().message,
              HasSubstr("is not skipped, because process 'desk' is lost, and the step can still be "
                        "undone if the process comes back"));

  desk_ = Join("desk", {test::Teleoperation()});

  EXPECT_THAT(WhyNot(), HasSubstr("): process 'desk' was restarted since; "));
  EXPECT_FALSE(Connection());
  EXPECT_TRUE(SkipNewestStep());
  EXPECT_TRUE(SkipNewestStep());
  EXPECT_EQ(WhyNot(), "there is nothing to undo");
}

TEST_P(UndoOrders, ADisconnectFromARemovedObjectCanBeSkipped) {
  ASSERT_TRUE(Connect(*client_));
  ASSERT_TRUE(Disconnect(*client_));
  robot_->Remove("arm");
  WaitUntilGone("robot", "arm");

  EXPECT_THAT(WhyNot(), HasSubstr("): no component 'robot/arm'"));
  EXPECT_TRUE(SkipNewestStep());
}

TEST_P(UndoOrders, FiftyRandomChangesAndFiftyUndosGiveTheFirstState) {
  constexpr int kSteps = 50;
  constexpr int kInterfaces = 5;
  const auto name = [](int number) { return "R" + std::to_string(number); };
  ComponentDescription panel = test::Teleoperation("panel");
  panel.required.clear();
  for (int i = 0; i < kInterfaces; ++i) panel.required.push_back(test::Robot(name(i)));
  const auto wall = Join("wall", {panel});
  robot_->Add(test::Arm("second"));
  ASSERT_TRUE(EventuallyTrue([&] { return gcm_->catalogue().FindComponent("robot", "second"); }));
  ASSERT_TRUE(Connect(*client_, {"wall", "panel", name(0)}));
  const Fingerprint before = gcm_->catalogue().ContentHash();
  std::mt19937 random(17);  // NOLINT(cert-msc51-cpp): the same on each run

  for (int step = 0; step < kSteps; ++step) {
    const InterfaceName required("wall", "panel", name(static_cast<int>(random() % kInterfaces)));
    const InterfaceName provided("robot", random() % 2 == 0 ? "arm" : "second", "Control");
    const Catalogue catalogue = gcm_->catalogue();
    const auto* now = catalogue.FindConnection(required);
    if (now == nullptr) {
      ASSERT_TRUE(Connect(*client_, required, provided));
    } else if (now->provided == provided) {
      ASSERT_TRUE(Disconnect(*client_, required));
    } else {
      ASSERT_TRUE(Replace(required, provided));
    }
  }
  ASSERT_EQ(Steps(*client_).size(), kSteps + 1U);
  for (int step = 0; step < kSteps; ++step) {
    const auto undone = Undo(*client_);
    ASSERT_TRUE(undone) << undone.error().message;
  }

  EXPECT_EQ(gcm_->catalogue().ContentHash(), before);
}

}  // namespace
}  // namespace tendon
