#include <gcm_gui/models/text.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/window/plots/mark_binding.h>
#include <gmock/gmock.h>

#include <chrono>

#include "support/sample_system.h"

namespace tendon::gui {
namespace {

std::int64_t SteadyTime() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class MarkBindingTest : public testing::Test {
 protected:
  MarkBindingTest() { Tell(); }

  void Tell() { store_.apply(system_.TakeChanges()); }
  [[nodiscard]] QStringList labels() const {
    QStringList labels;
    for (const Mark& mark : panel_.marks().all()) labels << mark.label;
    return labels;
  }
  void Finish(Action action, const QString& refusal) {
    activity_.finish(activity_.begin(std::move(action)), 0.01, refusal);
  }

  SystemBuilder system_ = LookSystem(0);
  CatalogueStore store_;
  ActivityModel activity_;
  PlotPanel panel_;
  MarkBinding binding_{panel_, store_, activity_};
  const InterfaceName required_{"desk", "teleoperation", "Robot"};
  const InterfaceName provided_{"robot", "controller", "Control"};
};

TEST_F(MarkBindingTest, WhatIsThereAlreadyMakesNoMark) { EXPECT_TRUE(labels().isEmpty()); }

TEST_F(MarkBindingTest, AConnectionIsMarkedWhoeverMadeIt) {
  system_.Connect(required_, provided_);
  Tell();
  system_.Disconnect(required_);
  Tell();

  EXPECT_EQ(labels(), (QStringList{"teleoperation connected", "teleoperation disconnected"}));
  EXPECT_FALSE(panel_.marks().all().back().is_bad);
}

TEST_F(MarkBindingTest, AStateThatChangesIsMarkedAndAFaultIsBad) {
  ComponentDescription arm = *system_.catalog().FindComponent("robot", "arm");
  arm.state = ComponentState::kFaulted;
  arm.fault = "too hot";
  system_.Component("robot", arm);
  Tell();

  ASSERT_EQ(labels(), QStringList{"arm faulted"});
  EXPECT_TRUE(panel_.marks().all().back().is_bad);
  EXPECT_EQ(panel_.marks().all().back().text, "robot/arm is faulted: too hot");
}

TEST_F(MarkBindingTest, AProcessThatIsLostAndComesBackIsMarked) {
  system_.Process("robot", ProcessState::kLost, 1);
  Tell();
  EXPECT_TRUE(labels().contains("robot lost"));
  system_.Process("robot", ProcessState::kAlive, 2, 2);
  Tell();
  EXPECT_TRUE(labels().contains("robot is back"));
}

TEST_F(MarkBindingTest, ACallIsMarkedWhenItWasMadeAndARefusalIsBad) {
  const std::int64_t before = SteadyTime();
  Action call;
  call.verb = Action::Verb::kCall;
  call.command = "robot/arm/Control.MoveTo";
  call.argument = "{\"x\": 1}";
  Finish(call, {});
  Finish(call, "not now");

  ASSERT_EQ(labels(), (QStringList{"MoveTo", "MoveTo"}));
  const Mark& first = panel_.marks().all().front();
  EXPECT_EQ(first.text, "call robot/arm/Control.MoveTo {\"x\": 1}");
  EXPECT_FALSE(first.is_bad);
  EXPECT_TRUE(panel_.marks().all().back().is_bad);
  constexpr std::int64_t kClocksApart = 60'000'000'000;  // ns
  EXPECT_GE(first.time_ns, before - kClocksApart);
}

TEST_F(MarkBindingTest, AnEventIsMarkedAtTheTimeItCame) {
  binding_.markEvent("robot/arm/Control.LimitExceeded", "{\"joint\": 2}", WallClock());

  ASSERT_EQ(labels(), QStringList{"LimitExceeded"});
  EXPECT_EQ(panel_.marks().all().back().kind, Mark::Kind::kEvent);
}

}  // namespace
}  // namespace tendon::gui
