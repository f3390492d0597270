#include <tendon/gcm/system/comparison.h>
#include <tendon/gcm/system/running_system.h>
#include <tendon/payload/json.h>
#include <tendon/task/threaded_task.h>

#include <array>
#include <functional>
#include <random>
#include <utility>

#include "core/process/lifecycle/lifecycle_fixture.h"

namespace {

using tendon::ComponentState;
using tendon::LifecycleVerb;

/// Remote orders become steps of the history.
class LifecycleUndo : public LifecycleFixture {};

INSTANTIATE_TEST_SUITE_P(Over, LifecycleUndo, testing::ValuesIn(PlainNetworkKinds()),
                         NameOfNetwork);

TEST_P(LifecycleUndo, RestoresARemovedComponentWithItsConnections) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp", R"({"brightness": 0.25})")), "");
  ASSERT_EQ(Reason(Create("Switch", "switch")), "");
  ASSERT_TRUE(robot_->Connect({"switch", "Lamp"}, {"lamp", "Control"}));
  ASSERT_EQ(Reason(Order(LifecycleVerb::kStart, "lamp")), "");
  ASSERT_TRUE(EventuallyTrue([&] { return gcm().catalogue().connections().size() == 1; }));
  ASSERT_EQ(Reason(Order(LifecycleVerb::kRemove, "lamp")), "");
  EXPECT_TRUE(robot_->connections().empty());

  EXPECT_EQ(Undone(), "remove lamp");

  EXPECT_EQ(Known("lamp").configuration, R"({"brightness":0.25})");
  EXPECT_EQ(Known("lamp").state, ComponentState::kActive);
  EXPECT_TRUE(EventuallyActive(*robot_, 1));
}

TEST_P(LifecycleUndo, RevertsStepsFromLastToFirst) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  ASSERT_EQ(Reason(Configure("lamp", R"({"brightness": 0.75})")), "");
  ASSERT_EQ(Reason(Order(LifecycleVerb::kStart, "lamp")), "");
  ASSERT_EQ(Reason(Order(LifecycleVerb::kSuspend, "lamp")), "");
  ASSERT_EQ(Reason(Order(LifecycleVerb::kStop, "lamp")), "");
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

TEST_P(LifecycleUndo, IsRefusedIfTheComponentHasChanged) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  ASSERT_TRUE(robot_->Start("lamp").ok());  // an order of the process' own program
  ASSERT_TRUE(EventuallyTrue([&] { return Known("lamp").state == ComponentState::kActive; }));

  EXPECT_THAT(Undone(), testing::HasSubstr("): robot/lamp is active now; stop it first; "));

  EXPECT_NE(robot_->Find("lamp"), nullptr);
}

TEST_P(LifecycleUndo, AnIneffectiveOrderRecordsNoStep) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  ASSERT_EQ(Reason(Order(LifecycleVerb::kStart, "lamp")), "");

  EXPECT_THAT(Reason(Order(LifecycleVerb::kStart, "lamp")), testing::HasSubstr("already"));

  EXPECT_THAT(Steps(), testing::ElementsAre("create lamp", "start lamp"));
}

TEST_P(LifecycleUndo, AnUnconnectableComponentIsRestoredButNotStarted) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  ASSERT_EQ(Reason(Create("Switch", "switch")), "");
  ASSERT_TRUE(robot_->Connect({"switch", "Lamp"}, {"lamp", "Control"}));
  ASSERT_EQ(Reason(Order(LifecycleVerb::kStart, "switch")), "");
  ASSERT_TRUE(EventuallyTrue([&] { return gcm().catalogue().connections().size() == 1; }));
  ASSERT_EQ(Reason(Order(LifecycleVerb::kRemove, "switch")), "");
  ASSERT_TRUE(robot_->Remove("lamp").ok());
  ASSERT_TRUE(EventuallyTrue([&] { return Known("lamp").name.empty(); }));

  EXPECT_THAT(Undone(), testing::HasSubstr("the component was created again, but not started, "
                                           "because its connections could not be restored"));

  EXPECT_EQ(robot_->Find("switch")->state(), ComponentState::kConstructed);
}

TEST_P(LifecycleUndo, RestoresThreadAndLeader) {
  ASSERT_EQ(Reason(Create("Lamp", "first")), "");
  ASSERT_EQ(Reason(Create("Lamp", "second")), "");
  ASSERT_TRUE(robot_->RunAfter("second", "first").ok());
  ASSERT_EQ(
      Reason(Order(LifecycleVerb::kRemove, "first")),
      "component 'first' cannot be removed remotely, because 'second' runs after it; remove that "
      "component first");
  auto& task = dynamic_cast<tendon::ThreadedTask&>(*robot_->Find("second"));
  const tendon::ThreadOptions options{.spin = std::chrono::microseconds(20)};
  task.SetThreadOptions(options);
  ASSERT_EQ(Reason(Configure("second", R"({"brightness": 0.75})")), "");
  EXPECT_EQ(robot_->SettingsOf("second")->thread, options);
  EXPECT_EQ(robot_->SettingsOf("second")->leader, "first");
  ASSERT_EQ(Reason(Order(LifecycleVerb::kRemove, "second")), "");

  EXPECT_EQ(Undone(), "remove second");

  EXPECT_EQ(robot_->SettingsOf("second")->thread, options);
  EXPECT_EQ(robot_->SettingsOf("second")->leader, "first");
  EXPECT_EQ(Known("second").configuration, R"({"brightness":0.75})");
}

TEST_P(LifecycleUndo, UndoingAStopRestartsItsFollowers) {
  for (const char* name : {"first", "second", "third", "idle"}) {
    ASSERT_EQ(Reason(Create("Lamp", name)), "");
  }
  ASSERT_TRUE(robot_->RunAfter("second", "first").ok());
  ASSERT_TRUE(robot_->RunAfter("third", "second").ok());
  ASSERT_TRUE(robot_->RunAfter("idle", "first").ok());
  for (const char* name : {"first", "second", "third"}) {
    ASSERT_EQ(Reason(Order(LifecycleVerb::kStart, name)), "");
  }
  ASSERT_EQ(Reason(Order(LifecycleVerb::kSuspend, "third")), "");
  ASSERT_TRUE(EventuallyTrue([&] { return Known("idle").leader == "first"; }));
  ASSERT_EQ(Reason(Order(LifecycleVerb::kStop, "first")), "");
  ASSERT_EQ(robot_->Find("third")->state(), ComponentState::kFinished);

  EXPECT_EQ(Undone(), "stop first");

  EXPECT_EQ(robot_->Find("first")->state(), ComponentState::kActive);
  EXPECT_EQ(robot_->Find("second")->state(), ComponentState::kActive);
  EXPECT_EQ(robot_->Find("third")->state(), ComponentState::kSuspended);
  EXPECT_EQ(robot_->Find("idle")->state(), ComponentState::kConstructed);
}

TEST_P(LifecycleUndo, RefusesToUndoAStopIfAFollowerHasChanged) {
  ASSERT_EQ(Reason(Create("Lamp", "first")), "");
  ASSERT_EQ(Reason(Create("Lamp", "second")), "");
  ASSERT_TRUE(robot_->RunAfter("second", "first").ok());
  for (const char* name : {"first", "second"}) {
    ASSERT_EQ(Reason(Order(LifecycleVerb::kStart, name)), "");
  }
  ASSERT_TRUE(EventuallyTrue([&] { return Known("second").leader == "first"; }));
  ASSERT_EQ(Reason(Order(LifecycleVerb::kStop, "first")), "");
  ASSERT_TRUE(robot_->Remove("second").ok());  // an order of the process' own program
  ASSERT_TRUE(EventuallyTrue([&] { return Known("second").name.empty(); }));

  EXPECT_THAT(Undone(), testing::HasSubstr("): robot/second no longer exists; "));

  EXPECT_EQ(robot_->Find("first")->state(), ComponentState::kFinished);
}

/// Gives random orders to four lamps. The lamp `second` can run after `first`.
class RandomOrders {
 public:
  explicit RandomOrders(std::function<tendon::ComponentDescription(const std::string&)> known)
      : known_(std::move(known)) {}

  /// Returns an order, which may be refused. It must be a complete order: suspending a leader also
  /// suspends its followers, so such an order is not returned.
  tendon::message::LifecycleOrder Next() {
    constexpr std::array kVerbs = {LifecycleVerb::kCreate, LifecycleVerb::kConfigure,
                                   LifecycleVerb::kStart,  LifecycleVerb::kSuspend,
                                   LifecycleVerb::kStop,   LifecycleVerb::kRemove};
    constexpr std::array kNames = {"first", "second", "third", "fourth"};
    for (;;) {
      tendon::message::LifecycleOrder order{.verb = kVerbs[random_() % kVerbs.size()],
                                            .process = "robot",
                                            .component = kNames[random_() % kNames.size()]};
      const bool leads = order.component == "first" && known_("second").leader == "first";
      const bool rests = leads && IsRunning(known_("second").state);
      if (rests && order.verb == LifecycleVerb::kSuspend) continue;
      const bool follows = order.component == "second" && known_("second").leader == "first";
      if (follows && known_("first").state != ComponentState::kActive) continue;
      const std::string brightness = std::to_string(1 + random_() % 9);
      if (order.verb == LifecycleVerb::kCreate) AddOrigin(order);
      if (order.verb == LifecycleVerb::kCreate || order.verb == LifecycleVerb::kConfigure) {
        order.configuration = R"({"brightness": 0.)" + brightness + "}";
      }
      return order;
    }
  }

 private:
  void AddOrigin(tendon::message::LifecycleOrder& order) {
    order.class_name = "Lamp";
    order.library = "lamps";
    const std::chrono::microseconds spin(random_() % 3);
    if (spin.count() > 0) order.thread = ToJson(tendon::ThreadOptions{.spin = spin});
    const bool follows = order.component == "second";
    if (follows && known_("first").state == ComponentState::kActive) order.leader = "first";
  }

  const std::function<tendon::ComponentDescription(const std::string&)> known_;
  std::mt19937 random_{23};  // NOLINT(cert-msc51-cpp): the same on each run
};

TEST_P(LifecycleUndo, FiftyRandomChangesAndFiftyUndosGiveTheFirstState) {
  constexpr int kSteps = 50;
  ASSERT_EQ(Reason(Create("Lamp", "first", R"({"brightness": 0.3})")), "");
  ASSERT_EQ(Reason(Order(LifecycleVerb::kStart, "first")), "");
  const tendon::SystemFile before = SystemOf(gcm().catalogue(), "x").file;
  RandomOrders orders([this](const std::string& name) { return Known(name); });
  int followers = 0;

  for (int made = 0; made < kSteps;) {
    const tendon::message::LifecycleOrder order = orders.Next();
    if (!Execute(*client_, order)) continue;
    ++made;
    followers += order.leader.empty() ? 0 : 1;
  }
  EXPECT_GT(followers, 0);
  for (int step = 0; step < kSteps; ++step) {
    const std::string undone = Undone();
    ASSERT_EQ(undone.find(':'), undone.npos) << step << ": " << undone;
  }

  const tendon::SystemFile after = SystemOf(gcm().catalogue(), "x").file;
  for (const auto& one :
       CompareSystems(before, after, tendon::StartComparison::kCompare).differences) {
    ADD_FAILURE() << one.what << ": " << one.how;
  }
}

TEST_P(LifecycleUndo, UndoesOnlyTheRequestedStep) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  ASSERT_EQ(Reason(Order(LifecycleVerb::kStart, "lamp")), "");

  const auto undone = tendon::Wait<tendon::message::HistoryEntry>(
      3 * kLong, [&](auto handler) { client_->Undo(handler, 1); });

  ASSERT_FALSE(undone);
  EXPECT_THAT(
      undone.error().message,
      testing::HasSubstr(
          "step 1 is not the newest step any more; the newest step is step 2 (start robot/lamp"));
  EXPECT_EQ(Known("lamp").state, ComponentState::kActive);
}

}  // namespace
