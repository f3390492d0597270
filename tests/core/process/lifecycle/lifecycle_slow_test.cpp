#include <atomic>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/process/lifecycle/lifecycle_fixture.h"
#include "support/folder.h"

namespace {

using tendon::ComponentState;
using tendon::ErrorCode;
using tendon::LifecycleVerb;
using testing::ElementsAre;
using testing::HasSubstr;

/// A component that reports its end.
class Ended final : public tendon::Component {
 public:
  Ended(std::string name, std::atomic<bool>& has_ended)
      : Component(std::move(name)), has_ended_(has_ended) {}

 private:
  void Cleanup() override { has_ended_ = true; }

  std::atomic<bool>& has_ended_;
};

/// Slow components, and orders that arrive while another order runs.
class LifecycleSlow : public LifecycleFixture {
 protected:
  void TearDown() override {
    Open();
    LifecycleFixture::TearDown();
  }
  /// Creates a component of a class that waits for the gate.
  void CreateGated(const std::string& class_name, const std::string& component) {
    ASSERT_EQ(Reason(Create(class_name, component, R"({"file": ")" + gate_ + "\"}")), "");
  }
  /// Opens the gate.
  void Open() { std::ofstream(gate_) << "open"; }
  /// Returns true if a component waits at the gate. It is not enough that the component is
  /// starting: a task that has not begun its Startup() stops at once.
  [[nodiscard]] bool IsAtGate() const { return std::filesystem::exists(gate_ + ".reached"); }

  const tendon::test::Folder folder_;
  const std::string gate_ = (folder_.path() / "open").string();
};

INSTANTIATE_TEST_SUITE_P(Over, LifecycleSlow, testing::ValuesIn(PlainNetworkKinds()),
                         NameOfNetwork);

TEST_P(LifecycleSlow, AStopOfOneComponentDoesNotWaitForTheStartOfAnother) {
  for (const std::string slow : {"SlowStarter", "SlowConfigurer"}) CreateGated(slow, slow);
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  ASSERT_EQ(Reason(Order(LifecycleVerb::kStart, "lamp")), "");
  Pending starter = OrderLater(LifecycleVerb::kStart, "SlowStarter");
  Pending configurer = OrderLater(LifecycleVerb::kStart, "SlowConfigurer");
  ASSERT_TRUE(EventuallyTrue([&] { return IsAtGate(); }));

  EXPECT_EQ(Reason(Order(LifecycleVerb::kStop, "lamp")), "");

  EXPECT_EQ(Known("lamp").state, ComponentState::kFinished);
  EXPECT_NE(Known("SlowStarter").state, ComponentState::kActive);
  EXPECT_NE(Known("SlowConfigurer").state, ComponentState::kActive);
  Open();
  EXPECT_EQ(Reason(starter.get()), "");
  EXPECT_EQ(Reason(configurer.get()), "");
}

TEST_P(LifecycleSlow, AStopIsAcceptedDuringTheStartOfItsComponent) {
  CreateGated("SlowStarter", "slow");
  Pending start = OrderLater(LifecycleVerb::kStart, "slow");
  ASSERT_TRUE(EventuallyTrue([&] { return IsAtGate(); }));
  EXPECT_THAT(Reason(Order(LifecycleVerb::kSuspend, "slow")), HasSubstr("by another request"));

  const auto stopped = Execute(*client_, {.verb = LifecycleVerb::kStop,
                                          .process = "robot",
                                          .component = "slow",
                                          .timeout = std::chrono::seconds(2)});
  ASSERT_FALSE(stopped);
  // The component was told to stop, but cannot stop yet.
  EXPECT_EQ(stopped.error().code, ErrorCode::kTimeout);
  Open();

  EXPECT_TRUE(robot_->WaitFor("slow", ComponentState::kFinished, kLong).ok());
  (void)start.get();  // the component may have been active for a moment
}

TEST_P(LifecycleSlow, AnUnconfirmedStartCanBeUndone) {
  CreateGated("SlowStarter", "slow");

  const auto started = Execute(*client_, {.verb = LifecycleVerb::kStart,
                                          .process = "robot",
                                          .component = "slow",
                                          .timeout = std::chrono::seconds(2)});

  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().code, ErrorCode::kTimeout);
  EXPECT_THAT(started.error().message, HasSubstr("; outcome unknown; see: gcm show robot/slow"));
  EXPECT_THAT(Steps(), ElementsAre("create slow", "start slow, unknown"));
  EXPECT_THAT(Undone(), HasSubstr("): robot/slow is ready now; "));

  Open();
  ASSERT_TRUE(EventuallyTrue([&] { return Known("slow").state == ComponentState::kActive; }));

  EXPECT_EQ(Undone(), "start slow");
  EXPECT_EQ(Known("slow").state, ComponentState::kFinished);
}

TEST_P(LifecycleSlow, AFailedUndoOfAStopLeavesAllStopped) {
  for (const char* name : {"first", "second"}) ASSERT_EQ(Reason(Create("Lamp", name)), "");
  CreateGated("Refuser", "third");
  for (const char* name : {"second", "third"}) {
    ASSERT_TRUE(robot_->RunAfter(name, "first").ok());
  }
  for (const char* name : {"first", "second", "third"}) {
    ASSERT_EQ(Reason(Order(LifecycleVerb::kStart, name)), "");
  }
  ASSERT_TRUE(EventuallyTrue([&] { return Known("third").leader == "first"; }));
  ASSERT_EQ(Reason(Order(LifecycleVerb::kStop, "first")), "");
  Open();

  EXPECT_THAT(Undone(), HasSubstr("it will not"));

  EXPECT_EQ(robot_->Find("first")->state(), ComponentState::kFinished);
  EXPECT_EQ(robot_->Find("second")->state(), ComponentState::kFinished);
  EXPECT_EQ(robot_->Find("third")->state(), ComponentState::kFaulted);
}

TEST_P(LifecycleSlow, AnOrderNotStartedInTimeIsDropped) {
  ASSERT_EQ(Reason(Load("lamps")), "");
  Pending made = OrderLater({.verb = LifecycleVerb::kCreate,
                             .process = "robot",
                             .component = "gate",
                             .class_name = "Gate",
                             .configuration = R"({"file": ")" + gate_ + "\"}"});
  ASSERT_TRUE(EventuallyTrue([&] { return IsAtGate(); }));

  const auto late = Execute(*client_, {.verb = LifecycleVerb::kCreate,
                                       .process = "robot",
                                       .component = "lamp",
                                       .class_name = "Lamp",
                                       .timeout = std::chrono::seconds(2)});

  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().code, ErrorCode::kFailed);
  EXPECT_THAT(late.error().message,
              HasSubstr("did not begin in time to create robot/lamp: nothing was done, "
                        "and the order is cancelled"));
  Open();
  EXPECT_EQ(Reason(made.get()), "");
  EXPECT_EQ(Reason(Create("Lamp", "after")), "");
  EXPECT_EQ(Known("lamp").name, "");
  EXPECT_THAT(Steps(), ElementsAre("create gate", "create after"));
}

TEST_P(LifecycleSlow, AHungComponentIsNotRemoved) {
  CreateGated("Hung", "hung");
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  ASSERT_TRUE(robot_->Connect({"hung", "Lamp"}, {"lamp", "Control"}));
  ASSERT_EQ(Reason(Order(LifecycleVerb::kStart, "hung")), "");
  ASSERT_TRUE(EventuallyTrue([&] { return IsAtGate(); }));

  const auto removed = Execute(*client_, {.verb = LifecycleVerb::kRemove,
                                          .process = "robot",
                                          .component = "hung",
                                          .timeout = std::chrono::seconds(2)});

  ASSERT_FALSE(removed);
  EXPECT_THAT(removed.error().message,
              HasSubstr("'hung' is not removed, because it did not stop in time"));
  EXPECT_EQ(robot_->connections().size(), 1U);
  EXPECT_NE(robot_->Find("hung"), nullptr);
}

TEST_P(LifecycleSlow, EndingAProcessStopsComponentsDuringAnOrder) {
  CreateGated("SlowConfigurer", "slow");
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  ASSERT_EQ(Reason(Order(LifecycleVerb::kStart, "lamp")), "");
  std::atomic<bool> has_ended = false;
  robot_->Add<Ended>("ended", has_ended);
  ASSERT_TRUE(robot_->Start("ended").ok());
  Pending start = OrderLater(LifecycleVerb::kStart, "slow");
  ASSERT_TRUE(EventuallyTrue([&] {  // the component is in its Configure()
    const auto stopped = robot_->Stop("slow", tendon::kNoWait);
    return !stopped && stopped.error().code == ErrorCode::kTimeout;
  }));

  std::thread ending([this] { robot_.reset(); });

  EXPECT_TRUE(EventuallyTrue([&] { return has_ended.load(); }));
  Open();
  ending.join();
}

}  // namespace
