#include <tendon/process/lifecycle/configuration_base.h>
#include <tendon/process/lifecycle/lifecycle_executor.h>

#include <filesystem>
#include <fstream>
#include <future>

#include "core/process/lifecycle/lifecycle_fixture.h"
#include "support/plant.h"
#include "support/record.h"

namespace {

using tendon::ComponentState;
using tendon::ErrorCode;
using tendon::LifecycleVerb;
using tendon::message::Classes;
using testing::HasSubstr;

class Lifecycle : public LifecycleFixture {
 protected:
  [[nodiscard]] tendon::Result<Classes> ClassesOf(const std::string& process) {
    return tendon::Wait<Classes>(kLong,
                                 [&](auto handler) { client_->GetClasses(process, handler); });
  }
};

INSTANTIATE_TEST_SUITE_P(Over, Lifecycle, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

TEST_P(Lifecycle, ComponentsAreControlledRemotely) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp", "{\n  \"brightness\": 0.25\n}")), "");
  EXPECT_EQ(Known("lamp").class_name, "Lamp");
  EXPECT_EQ(Known("lamp").library, "lamps");
  EXPECT_EQ(Known("lamp").configuration, R"({"brightness":0.25})");
  EXPECT_EQ(Known("lamp").state, ComponentState::kConstructed);

  EXPECT_EQ(Reason(Order(LifecycleVerb::kStart, "lamp")), "");
  EXPECT_EQ(Known("lamp").state, ComponentState::kActive);
  EXPECT_EQ(Reason(Order(LifecycleVerb::kSuspend, "lamp")), "");
  EXPECT_EQ(Known("lamp").state, ComponentState::kSuspended);
  EXPECT_EQ(Reason(Order(LifecycleVerb::kRestart, "lamp")), "");
  EXPECT_EQ(Known("lamp").state, ComponentState::kActive);
  EXPECT_EQ(Reason(Order(LifecycleVerb::kStop, "lamp")), "");
  EXPECT_EQ(Known("lamp").state, ComponentState::kFinished);

  EXPECT_EQ(Reason(Order(LifecycleVerb::kRemove, "lamp")), "");
  EXPECT_EQ(Known("lamp").name, "");
  EXPECT_EQ(robot_->Find("lamp"), nullptr);
}

TEST_P(Lifecycle, AProcessListsItsClassesAndConfigurations) {
  const auto before = ClassesOf("robot");
  ASSERT_TRUE(before) << before.error().message;
  EXPECT_TRUE(before->classes.empty());
  EXPECT_THAT(before->plugins, testing::Contains("lamps"));

  ASSERT_EQ(Reason(Load("lamps")), "");

  const auto all = ClassesOf("robot");
  ASSERT_TRUE(all) << all.error().message;
  ASSERT_EQ(all->classes.size(), 7U);
  const tendon::ClassDescription& lamp = all->classes[2];
  EXPECT_EQ(lamp.name, "Lamp");
  EXPECT_EQ(lamp.library, "lamps");
  EXPECT_EQ(lamp.defaults, R"({"brightness":0.5})");
  const auto schema = tendon::Schema::Parse(lamp.configuration);
  ASSERT_TRUE(schema) << schema.error().message;
  EXPECT_EQ(schema->TypeName(), "lamps.LampConfiguration");
  EXPECT_THAT(lamp.configuration, HasSubstr("@ 0 to 1"));
  EXPECT_EQ(ClassesOf("robbot").error().message, "no process 'robbot'; did you mean 'robot'?");
}

TEST_P(Lifecycle, FindsALoadedClassWithoutItsLibrary) {
  const tendon::message::LifecycleOrder order{.verb = LifecycleVerb::kCreate,
                                              .process = "robot",
                                              .component = "lamp",
                                              .class_name = "Lamp"};
  EXPECT_EQ(Reason(Execute(*client_, order)),
            "no library that process 'robot' has loaded has a class 'Lamp'; load the library that "
            "has this class, or give the name of that library");
  ASSERT_EQ(Reason(Load("lamps")), "");

  EXPECT_EQ(Reason(Execute(*client_, order)), "");

  EXPECT_EQ(Known("lamp").library, "lamps");
}

TEST_P(Lifecycle, ForwardsARefusalOfTheProcess) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  robot_->Add<plant::Plant>("plant");
  ASSERT_TRUE(EventuallyTrue([&] { return !Known("plant").name.empty(); }));
  const auto before = gcm().catalogue().ContentHash();

  EXPECT_THAT(Reason(Load("lamp")), HasSubstr("no plug-in 'lamp'; did you mean 'lamps'?"));
  EXPECT_THAT(Reason(Load("../lamps")), HasSubstr("plug-in name '../lamps' has '.' at 1"));
  EXPECT_EQ(Reason(Create("Lampe", "other")),
            "no component class 'Lampe'; did you mean 'Lamp'? (plug-in lamps.so)");
  EXPECT_EQ(
      Reason(Create("Lamp", "other", R"({"brightness": 7})")),
      "component 'other' (class Lamp): brightness: expected a number from 0 to 1, got number 7 "
      "(plug-in lamps.so)");
  EXPECT_EQ(Reason(Create("Lamp", "other", R"({"brightness": 0})")),
            "component 'other' (class Lamp): its constructor failed: a black lamp is none (plug-in "
            "lamps.so)");
  EXPECT_EQ(Reason(Create("Lamp", "a b")),
            "component name 'a b' has ' ' at 2; allowed: letters digits _ - (max 64)");
  EXPECT_EQ(Reason(Create("Lamp", "lamp")),
            "component 'lamp' already exists in process 'robot'; choose another name, or remove it "
            "first");
  EXPECT_EQ(Reason(Order(LifecycleVerb::kStop, "lamp")),
            "component 'lamp' is constructed and not active; there is nothing to stop");
  EXPECT_EQ(Reason(Order(LifecycleVerb::kRemove, "plant")),
            "component 'plant' cannot be removed remotely, because the program of process 'robot' "
            "created the component itself; it can only be started and stopped");
  EXPECT_THAT(Reason(Order(LifecycleVerb::kStart, "lam")),
              HasSubstr("no component 'robot/lam'; did you mean 'lamp'?"));

  EXPECT_EQ(gcm().catalogue().ContentHash(), before);
  const auto history = tendon::Wait<tendon::message::History>(
      kLong, [&](auto handler) { client_->GetHistory(handler); });
  EXPECT_EQ(history->entries.size(), 1U);
}

TEST_P(Lifecycle, AProcessWithoutPlugInsOnlyStartsComponents) {
  const auto desk = Start("desk");
  desk->Add<plant::Plant>("plant");
  ASSERT_TRUE(EventuallyTrue(
      [&] { return client_->catalogue().FindComponent("desk", "plant") != nullptr; }));

  EXPECT_EQ(
      Reason(Execute(*client_, {.verb = LifecycleVerb::kLoad, .process = "desk", .library = "x"})),
      "process 'desk' cannot create components on request, because its program does not load "
      "plug-ins; the program lcm does");
  EXPECT_EQ(
      Reason(Execute(*client_,
                     {.verb = LifecycleVerb::kStart, .process = "desk", .component = "plant"})),
      "");
  EXPECT_EQ(desk->Find("plant")->state(), ComponentState::kActive);
}

TEST_P(Lifecycle, ASlowPlugInBlocksNothingElse) {
  const tendon::test::Folder folder;
  const std::string file = (folder.path() / "open").string();
  ASSERT_EQ(Reason(Load("lamps")), "");
  std::promise<tendon::Result<void>> made;
  client_->ExecuteLifecycleOrder({.verb = LifecycleVerb::kCreate,
                                  .process = "robot",
                                  .component = "gate",
                                  .class_name = "Gate",
                                  .configuration = R"({"file": ")" + file + "\"}"},
                                 [&](const auto& result) { made.set_value(result); });
  ASSERT_TRUE(EventuallyTrue([&] { return std::filesystem::exists(file + ".reached"); }));

  const auto late = Execute(*client_, {.verb = LifecycleVerb::kCreate,
                                       .process = "robot",
                                       .component = "lamp",
                                       .class_name = "Lamp",
                                       .timeout = std::chrono::milliseconds(1)});
  EXPECT_FALSE(late);  // nobody waits for this answer any more
  robot_->Add<plant::Plant>("plant");
  EXPECT_TRUE(EventuallyTrue([&] { return !Known("plant").name.empty(); }));
  std::ofstream(file) << "now";
  EXPECT_EQ(Reason(made.get_future().get()), "");
  EXPECT_EQ(Reason(Create("Lamp", "after")), "");

  EXPECT_EQ(Known("gate").class_name, "Gate");
  EXPECT_EQ(Known("lamp").name, "");  // the late order was not executed
}

TEST_P(Lifecycle, RefusesAnOrderForAnEarlierInstance) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");

  EXPECT_EQ(
      Reason(Execute(*client_, {.verb = LifecycleVerb::kStart,
                                .process = "robot",
                                .instance = robot_->instance() + 1,
                                .component = "lamp"})),
      "process 'robot' was restarted meanwhile: nothing was done; check the process and try again");

  EXPECT_EQ(robot_->Find("lamp")->state(), ComponentState::kConstructed);
}

TEST_P(Lifecycle, AViewerIsDenied) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  const auto viewer = NewClient(tendon::Role::kViewer);

  const auto started =
      Execute(*viewer, {.verb = LifecycleVerb::kStart, .process = "robot", .component = "lamp"});

  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().code, ErrorCode::kDenied);
  EXPECT_EQ(robot_->Find("lamp")->state(), ComponentState::kConstructed);
  const auto all =
      tendon::Wait<Classes>(kLong, [&](auto handler) { viewer->GetClasses("robot", handler); });
  EXPECT_TRUE(all) << all.error().message;
}

TEST_P(Lifecycle, AReconfiguredComponentKeepsItsConnections) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  ASSERT_EQ(Reason(Create("Switch", "switch")), "");
  ASSERT_TRUE(robot_->Connect({"switch", "Lamp"}, {"lamp", "Control"}));
  ASSERT_EQ(Reason(Order(LifecycleVerb::kStart, "lamp")), "");
  EXPECT_EQ(Reason(Configure("lamp", R"({"brightness": 0.75})")),
            "component 'lamp' is active; stop it first to configure it again");
  ASSERT_EQ(Reason(Order(LifecycleVerb::kStop, "lamp")), "");
  EXPECT_THAT(Reason(Configure("lamp", R"({"brightness": 7})")), HasSubstr("from 0 to 1"));
  EXPECT_EQ(Known("lamp").configuration, "");

  EXPECT_EQ(Reason(Configure("lamp", R"({"brightness": 0.75})")), "");

  EXPECT_EQ(Known("lamp").configuration, R"({"brightness":0.75})");
  EXPECT_TRUE(EventuallyActive(*robot_, 1));
}

/// Records which components were reported as removed.
class Departures final : public tendon::GcmListener {
 public:
  void OnSnapshot(const tendon::Catalogue& /*catalogue*/) override {}
  void OnChanges(const std::vector<tendon::CatalogueChange>& changes) override {
    for (const auto& change : changes) {
      if (change.kind == tendon::CatalogueChange::Kind::kComponentRemoved) {
        gone_.Add(change.component);
      }
    }
  }
  void OnGcmLost(const tendon::Error& /*reason*/) override {}
  [[nodiscard]] std::vector<std::string> gone() const { return gone_.values(); }

 private:
  tendon::test::Record<std::string> gone_;
};

TEST_P(Lifecycle, WatchersSeeNoRemovalDuringReconfiguration) {
  const auto departures = std::make_shared<Departures>();
  tendon::GcmClient watcher(NewMiddleware(),
                            {.name = "watcher", .address = gcm().address(), .timeout = kLong},
                            departures);
  ASSERT_TRUE(watcher.WaitUntilWatching().ok());
  ASSERT_EQ(Reason(Create("Lamp", "lamp")), "");
  ASSERT_EQ(Reason(Create("Switch", "switch")), "");
  ASSERT_TRUE(robot_->Connect({"switch", "Lamp"}, {"lamp", "Control"}));

  for (const std::string brightness : {"0.25", "0.5", "0.75", "1"}) {
    EXPECT_EQ(Reason(Configure("lamp", R"({"brightness":)" + brightness + "}")), "");
  }
  EXPECT_EQ(Reason(Order(LifecycleVerb::kRemove, "switch")), "");

  EXPECT_TRUE(EventuallyTrue([&] { return !departures->gone().empty(); }));
  EXPECT_EQ(departures->gone(), std::vector<std::string>{"switch"});
}

TEST_P(Lifecycle, TheSecondOfTwoConflictingChangesIsRefused) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp", R"({"brightness": 0.25})")), "");
  const auto change = [this](const std::string& seen, const std::string& configuration) {
    return Reason(Execute(*client_, {.verb = LifecycleVerb::kConfigure,
                                     .process = "robot",
                                     .component = "lamp",
                                     .configuration = configuration,
                                     .based_on = tendon::BaseOf(seen)}));
  };
  const std::string seen = Known("lamp").configuration;

  EXPECT_EQ(change(seen, R"({"brightness": 0.5})"), "");
  EXPECT_THAT(
      change(seen, R"({"brightness": 0.75})"),
      testing::MatchesRegex(
          "the configuration of robot/lamp was changed meanwhile by test at ....-..-.. ..:..:..: "
          "nothing was done; to see the configuration: gcm show robot/lamp; then try again"));

  EXPECT_EQ(Known("lamp").configuration, R"({"brightness":0.5})");
  EXPECT_THAT(Steps(), testing::ElementsAre("create lamp", "configure lamp"));
  EXPECT_EQ(change(Known("lamp").configuration, R"({"brightness": 0.75})"), "");
}

TEST_P(Lifecycle, AChangeConflictingWithAnUndoNamesItsAuthor) {
  ASSERT_EQ(Reason(Create("Lamp", "lamp", R"({"brightness": 0.25})")), "");
  ASSERT_EQ(Reason(Configure("lamp", R"({"brightness": 0.5})")), "");
  ASSERT_EQ(Reason(Configure("lamp", R"({"brightness": 0.75})")), "");
  const std::string seen = Known("lamp").configuration;
  ASSERT_EQ(Undone(), "configure lamp");
  const auto other = NewClient(tendon::Role::kOperator, "somebody");
  const auto undone = tendon::Wait<tendon::message::HistoryEntry>(
      2 * kLong, [&](auto handler) { other->Undo(handler); });
  ASSERT_TRUE(undone) << undone.error().message;

  EXPECT_THAT(Reason(Execute(*client_, {.verb = LifecycleVerb::kConfigure,
                                        .process = "robot",
                                        .component = "lamp",
                                        .configuration = R"({"brightness": 0.125})",
                                        .based_on = tendon::BaseOf(seen)})),
              testing::MatchesRegex("the configuration of robot/lamp was changed meanwhile by "
                                    "somebody at ....-..-.. ..:..:..: nothing was done; .*"));

  EXPECT_EQ(Known("lamp").configuration, R"({"brightness":0.25})");
}

TEST_P(Lifecycle, TheProviderReportsTheConnectionsItServes) {
  robot_->Add<plant::Plant>("plant");
  const auto desk = Start("desk");
  desk->Add<plant::Operator>("operator");
  const tendon::message::ConnectionEnds ends{{"desk", "operator", "Robot"},
                                             {"robot", "plant", "Control"}};
  const auto served = [&] {
    return tendon::Wait<tendon::ConnectionCounts>(
        kLong, [&](auto handler) { client_->GetProviderCounts(ends, handler); });
  };
  ASSERT_TRUE(EventuallyTrue([&] { return !Known("plant").name.empty(); }));
  EXPECT_EQ(served().error().code, ErrorCode::kNotFound);
  EXPECT_EQ(served().error().message, "process 'robot' has no connection from desk/operator/Robot");

  ASSERT_TRUE(desk->Connect(ends.required, ends.provided));
  EXPECT_TRUE(EventuallyActive(*desk, 1));
  const auto counts = served();
  ASSERT_TRUE(counts) << counts.error().message;
  EXPECT_EQ(counts->capacity, 64U);

  ASSERT_TRUE(desk->Disconnect(ends.required));
  EXPECT_TRUE(EventuallyTrue([&] { return !served(); }));
}

TEST(LifecycleExecutor, RefusesAnOrderBasedOnAnotherConfiguration) {
  tendon::LocalManager manager;
  tendon::LifecycleExecutor executor(
      {.manager = manager, .process = "robot", .loader = LoaderOfLamps()});
  const auto obey = [&executor](tendon::message::LifecycleOrder order) {
    order.process = "robot";
    order.component = "lamp";
    order.timeout = std::chrono::minutes(1);
    std::promise<std::string> reason;
    executor.ExecuteOrder(
        order, [] { return tendon::Result<void>(); },
        [&](const auto& obeyed) { reason.set_value(obeyed ? "" : obeyed.error().message); });
    return reason.get_future().get();
  };
  const auto configure = [&obey](const std::string& seen) {
    return obey({.verb = LifecycleVerb::kConfigure,
                 .configuration = R"({"brightness": 0.5})",
                 .based_on = tendon::BaseOf(seen)});
  };
  ASSERT_EQ(obey({.verb = LifecycleVerb::kCreate, .class_name = "Lamp", .library = "lamps"}), "");

  EXPECT_EQ(configure(R"({"brightness":0.25})"),
            "the configuration of robot/lamp was changed meanwhile: nothing was done; to see the "
            "configuration: gcm show robot/lamp; then try again");
  EXPECT_EQ(configure(""), "");
  EXPECT_THAT(configure(""), HasSubstr("changed meanwhile"));
  executor.Stop();
}

}  // namespace
