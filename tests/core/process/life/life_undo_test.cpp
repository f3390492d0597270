#include <tendon/task/thread/threaded_task.h>

#include "core/process/life/life_fixture.h"

namespace {

using tendon::ComponentState;
using tendon::LifeVerb;

/// What was ordered from afar is a step of the history.
class LifeUndo : public LifeFixture {};

INSTANTIATE_TEST_SUITE_P(Over, LifeUndo, testing::ValuesIn(PlainNetworkKinds()), NameOfNetwork);

TEST_P(LifeUndo, ARemovedComponentComesBackAsItWasWithItsConnections) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp", R"({"brightness": 0.25})")), "");
  ASSERT_EQ(Reason(Create("Switch", "switch")), "");
  ASSERT_TRUE(robot_->Connect({"switch", "Lamp"}, {"lamp", "Control"}));
  ASSERT_EQ(Reason(Order(LifeVerb::kStart, "lamp")), "");
  ASSERT_TRUE(EventuallyTrue([&] { return gcm().catalog().connections().size() == 1; }));
  ASSERT_EQ(Reason(Order(LifeVerb::kRemove, "lamp")), "");
  EXPECT_TRUE(robot_->connections().empty());

  EXPECT_EQ(Undone(), "remove lamp");

  EXPECT_EQ(Known("lamp").configuration, R"({"brightness":0.25})");
  EXPECT_EQ(Known("lamp").state, ComponentState::kActive);
  EXPECT_TRUE(EventuallyActive(*robot_, 1));
}

TEST_P(LifeUndo, StepsAreTakenBackFromTheLastToTheFirst) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  ASSERT_EQ(Reason(Configure("lamp", R"({"brightness": 0.75})")), "");
  ASSERT_EQ(Reason(Order(LifeVerb::kStart, "lamp")), "");
  ASSERT_EQ(Reason(Order(LifeVerb::kSuspend, "lamp")), "");
  ASSERT_EQ(Reason(Order(LifeVerb::kStop, "lamp")), "");
  ASSERT_EQ(Reason(Configure("lamp", R"({"brightness": 0.125})")), "");

  EXPECT_EQ(Undone(), "configure lamp");
  EXPECT_EQ(Known("lamp").configuration, R"({"brightness":0.75})");
  EXPECT_EQ(Undone(), "stop lamp");
  EXPECT_EQ(Known("lamp").state, ComponentState::kSuspended);
  EXPECT_EQ(Undone(), "suspend lamp");
  EXPECT_EQ(Known("lamp").state, ComponentState::kActive);
  EXPECT_EQ(Undone(), "start lamp");
  EXPECT_EQ(Known("lamp").state, ComponentState::kFinished);
  EXPECT_EQ(Undone(), "configure lamp");
  EXPECT_EQ(Known("lamp").configuration, "");
  EXPECT_EQ(Undone(), "create lamp");
  EXPECT_EQ(Known("lamp").name, "");
  EXPECT_EQ(Undone(), "there is nothing to undo");
}

TEST_P(LifeUndo, RefusesWhereTheComponentHasChangedSince) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  ASSERT_TRUE(robot_->Start("lamp").ok());  // by its program
  ASSERT_TRUE(EventuallyTrue([&] { return Known("lamp").state == ComponentState::kActive; }));

  EXPECT_THAT(Undone(), testing::HasSubstr("): robot/lamp is active since; stop it first; "));

  EXPECT_NE(robot_->Find("lamp"), nullptr);
}

TEST_P(LifeUndo, WhatWasNotRecordedByAnIdleOrderIsNotUndone) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  ASSERT_EQ(Reason(Order(LifeVerb::kStart, "lamp")), "");

  EXPECT_THAT(Reason(Order(LifeVerb::kStart, "lamp")), testing::HasSubstr("already"));

  EXPECT_THAT(Steps(), testing::ElementsAre("create lamp", "start lamp"));
}

TEST_P(LifeUndo, AComponentThatCannotBeConnectedAsBeforeIsThereButDoesNotRun) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  ASSERT_EQ(Reason(Create("Switch", "switch")), "");
  ASSERT_TRUE(robot_->Connect({"switch", "Lamp"}, {"lamp", "Control"}));
  ASSERT_EQ(Reason(Order(LifeVerb::kStart, "switch")), "");
  ASSERT_TRUE(EventuallyTrue([&] { return gcm().catalog().connections().size() == 1; }));
  ASSERT_EQ(Reason(Order(LifeVerb::kRemove, "switch")), "");
  ASSERT_TRUE(robot_->Remove("lamp").ok());
  ASSERT_TRUE(EventuallyTrue([&] { return Known("lamp").name.empty(); }));

  EXPECT_THAT(Undone(), testing::HasSubstr("it is there again, but does not run, for it is not "
                                           "connected as before"));

  EXPECT_EQ(robot_->Find("switch")->state(), ComponentState::kConstructed);
}

TEST_P(LifeUndo, AComponentMadeAgainRunsInItsThreadAndAfterItsLeader) {
  ASSERT_EQ(Reason(Create("Lamp", "first")), "");
  ASSERT_EQ(Reason(Create("Lamp", "second")), "");
  ASSERT_TRUE(robot_->RunAfter("second", "first").ok());
  ASSERT_EQ(
      Reason(Order(LifeVerb::kRemove, "first")),
      "component 'first' cannot be removed from afar, for 'second' runs after it; remove that "
      "first");
  auto& task = dynamic_cast<tendon::ThreadedTask&>(*robot_->Find("second"));
  const tendon::ThreadOptions options{.spin = std::chrono::microseconds(20)};
  task.SetThreadOptions(options);
  ASSERT_EQ(Reason(Configure("second", R"({"brightness": 0.75})")), "");
  EXPECT_EQ(robot_->SettingsOf("second")->thread, options);
  EXPECT_EQ(robot_->SettingsOf("second")->leader, "first");
  ASSERT_EQ(Reason(Order(LifeVerb::kRemove, "second")), "");

  EXPECT_EQ(Undone(), "remove second");

  EXPECT_EQ(robot_->SettingsOf("second")->thread, options);
  EXPECT_EQ(robot_->SettingsOf("second")->leader, "first");
  EXPECT_EQ(Known("second").configuration, R"({"brightness":0.75})");
}

TEST_P(LifeUndo, OnlyTheStepThatIsMeantIsTakenBack) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  ASSERT_EQ(Reason(Order(LifeVerb::kStart, "lamp")), "");

  const auto undone = tendon::Wait<tendon::message::HistoryEntry>(
      3 * kLong, [&](auto handler) { client_->Undo(handler, 1); });

  ASSERT_FALSE(undone);
  EXPECT_THAT(
      undone.error().message,
      testing::HasSubstr("step 1 is not the newest any more, but step 2 (start robot/lamp"));
  EXPECT_EQ(Known("lamp").state, ComponentState::kActive);
}

}  // namespace
