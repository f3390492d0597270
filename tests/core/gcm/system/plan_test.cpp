#include <gmock/gmock.h>
#include <tendon/gcm/system/plan.h>
#include <tendon/gcm/system/running_system.h>
#include <tests/core/gcm/system/running_catalogue.h>

#include <algorithm>

namespace tendon {
namespace {

using test::CatalogBuilder;
using test::TextsOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

SystemFile DemoFile() { return SystemOf(test::RunningDemo().catalogue(), "demo").file; }

/// Returns the plan that changes the running demo to the system of the file.
Plan PlanFromDemo(const SystemFile& wanted) {
  return MakePlan(test::RunningDemo().catalogue(), wanted);
}

TEST(Plan, IsEmptyForTheRunningSystem) {
  const Plan plan = PlanFromDemo(DemoFile());

  EXPECT_THAT(plan.steps, IsEmpty());
  EXPECT_THAT(plan.obstacles, IsEmpty());
  EXPECT_EQ(plan.untouched, 6U);
}

TEST(Plan, StartsTheProcessesOfTheGcm) {
  CatalogBuilder lost;
  lost.Process("desk", {test::Teleoperation()}, ProcessState::kLost)
      .Connection(test::kNeeded, test::kOffered, ConnectionState::kPending);
  SystemFile wanted = DemoFile();
  wanted.processes[0].start = SystemFile::Start{RestartPolicy::kOnFailure};
  wanted.processes[1].start = SystemFile::Start{};
  wanted.processes[1].components.pop_back();
  wanted.processes[1].components[0].thread.emplace().lock_memory = true;

  const Plan plan = MakePlan(lost.catalogue(), wanted);

  EXPECT_THAT(plan.obstacles, IsEmpty());
  EXPECT_THAT(
      TextsOf(plan),
      ElementsAre("start process desk (restart on-failure)", "start process robot (restart never)",
                  "create desk/teleoperation (Teleoperation of teleoperation)",
                  "create robot/arm (SimulatedArm of simulated_arm)",
                  "connect desk/teleoperation/Robot -> robot/arm/Control", "start robot/arm",
                  "start desk/teleoperation"));
  for (const PlanStep& step : plan.steps) EXPECT_EQ(step.instance, 0U) << ToString(step);
  EXPECT_EQ(plan.untouched, 0U);
  EXPECT_FALSE(plan.TakesAway());
}

TEST(Plan, KeepsAPresentProcessWhateverStartedIt) {
  SystemFile wanted = DemoFile();
  for (auto& process : wanted.processes) process.start = SystemFile::Start{};

  EXPECT_THAT(PlanFromDemo(wanted).steps, IsEmpty());
}

TEST(Plan, BuildsASystemInEmptyProcessesInOrder) {
  CatalogBuilder empty;
  empty.Process("robot", {}).Process("desk", {});
  SystemFile wanted = DemoFile();
  wanted.processes[1].components[1].state = ComponentState::kSuspended;
  wanted.processes[0].components[0].state = ComponentState::kConstructed;

  const Plan plan = MakePlan(empty.catalogue(), wanted);

  EXPECT_THAT(plan.obstacles, IsEmpty());
  EXPECT_THAT(TextsOf(plan),
              ElementsAre("create desk/teleoperation (Teleoperation of teleoperation)",
                          "create robot/arm (SimulatedArm of simulated_arm)",
                          "create robot/spare (SimulatedArm of simulated_arm)",
                          "connect desk/teleoperation/Robot -> robot/arm/Control",
                          "start robot/arm", "start robot/spare, then suspend it"));
  EXPECT_EQ(plan.steps[1].component, wanted.processes[1].components[0]);
  EXPECT_EQ(plan.untouched, 2U);   // the two processes
  EXPECT_FALSE(plan.TakesAway());  // a suspended component did not run before
}

TEST(Plan, RemovesObjectsThatTheFileLacks) {
  SystemFile wanted = DemoFile();
  wanted.processes[1].components.pop_back();
  wanted.connections.clear();

  EXPECT_THAT(
      TextsOf(PlanFromDemo(wanted)),
      ElementsAre("stop robot/spare", "disconnect desk/teleoperation/Robot -> robot/arm/Control",
                  "remove robot/spare"));
}

TEST(Plan, DisconnectsUnwantedPendingConnections) {
  CatalogBuilder builder;
  builder.Process("desk", {test::Teleoperation()})
      .Connection(test::kNeeded, test::kOffered, ConnectionState::kPending);
  const SystemFile wanted = SystemOf(builder.catalogue(), "x").file;

  EXPECT_THAT(TextsOf(MakePlan(builder.catalogue(), wanted)),
              ElementsAre("disconnect desk/teleoperation/Robot -> robot/arm/Control"));
}

TEST(Plan, IgnoresOtherProcesses) {
  SystemFile wanted = DemoFile();
  wanted.processes.erase(wanted.processes.begin());  // removes the desk
  wanted.connections.clear();

  EXPECT_THAT(PlanFromDemo(wanted).steps, IsEmpty());
}

TEST(Plan, ANewConfigurationReconfiguresAStoppedComponent) {
  SystemFile wanted = DemoFile();
  wanted.processes[1].components[0].configuration = R"({"noise":1})";

  const Plan plan = PlanFromDemo(wanted);

  EXPECT_THAT(TextsOf(plan),
              ElementsAre("stop robot/arm", "configure robot/arm", "start robot/arm"));
  EXPECT_TRUE(plan.steps[0].takes_away);
  EXPECT_EQ(plan.steps[1].component, wanted.processes[1].components[0]);
}

TEST(Plan, AnotherClassRecreatesAndReconnects) {
  SystemFile wanted = DemoFile();
  wanted.processes[1].components[0].class_name = "OtherArm";

  EXPECT_THAT(
      TextsOf(PlanFromDemo(wanted)),
      ElementsAre("stop robot/arm", "remove robot/arm",
                  "create robot/arm (OtherArm of simulated_arm)",
                  "connect desk/teleoperation/Robot -> robot/arm/Control", "start robot/arm"));
}

/// A robot whose filter runs after its arm, and whose logger runs after its filter.
CatalogBuilder RunningChain(ComponentState state = ComponentState::kActive) {
  const auto made = [state](const std::string& name, const std::string& leader) {
    ComponentDescription one = test::Arm(name);
    one.thread = {ThreadOptions()};
    one.leader = leader;
    one.state = state;
    return one;
  };
  CatalogBuilder builder;
  builder.Process("robot", {made("arm", ""), made("filter", "arm"), made("a-logger", "filter")});
  return builder;
}

SystemFile::Component& ComponentIn(SystemFile& system, const std::string& name) {
  auto& components = system.processes[0].components;
  return *std::find_if(components.begin(), components.end(),
                       [&](const auto& one) { return one.name == name; });
}

TEST(Plan, CreatesLeadersBeforeTheirFollowers) {
  CatalogBuilder empty;
  empty.Process("robot", {});
  const SystemFile wanted = SystemOf(RunningChain().catalogue(), "x").file;

  EXPECT_THAT(
      TextsOf(MakePlan(empty.catalogue(), wanted)),
      ElementsAre("create robot/arm (SimulatedArm of simulated_arm)",
                  "create robot/filter (SimulatedArm of simulated_arm, which runs after arm)",
                  "create robot/a-logger (SimulatedArm of simulated_arm, which runs after filter)",
                  "start robot/arm", "start robot/filter", "start robot/a-logger"));
  EXPECT_THAT(TextsOf(MakePlan(RunningChain().catalogue(), wanted)), IsEmpty());
}

TEST(Plan, SuspendsALeaderAfterItsFollowersHaveStarted) {
  CatalogBuilder empty;
  empty.Process("robot", {});
  SystemFile wanted = SystemOf(RunningChain(ComponentState::kSuspended).catalogue(), "x").file;

  const auto texts = TextsOf(MakePlan(empty.catalogue(), wanted));

  ASSERT_EQ(texts.size(), 8U);
  EXPECT_THAT(
      std::vector(texts.begin() + 3, texts.end()),
      ElementsAre("start robot/arm", "start robot/filter", "start robot/a-logger, then suspend it",
                  "suspend robot/arm", "suspend robot/filter"));
}

TEST(Plan, AnotherThreadRecreatesTheComponent) {
  SystemFile wanted = SystemOf(RunningChain().catalogue(), "x").file;
  ComponentIn(wanted, "a-logger").thread->spin = std::chrono::microseconds(10);

  EXPECT_THAT(
      TextsOf(MakePlan(RunningChain().catalogue(), wanted)),
      ElementsAre("stop robot/a-logger", "remove robot/a-logger",
                  "create robot/a-logger (SimulatedArm of simulated_arm, which runs after filter)",
                  "start robot/a-logger"));
  ComponentIn(wanted, "a-logger").thread.reset();
  ComponentIn(wanted, "a-logger").runs_after.clear();
  EXPECT_THAT(TextsOf(MakePlan(RunningChain().catalogue(), wanted)), IsEmpty());
  ComponentIn(wanted, "a-logger").thread.emplace();
  EXPECT_THAT(
      TextsOf(MakePlan(RunningChain().catalogue(), wanted)),
      ElementsAre("stop robot/a-logger", "remove robot/a-logger",
                  "create robot/a-logger (SimulatedArm of simulated_arm)", "start robot/a-logger"));
}

TEST(Plan, RecreatesAComponentWithItsFollowers) {
  SystemFile wanted = SystemOf(RunningChain().catalogue(), "x").file;
  ComponentIn(wanted, "arm").configuration = R"({"noise":1})";
  // The file does not specify this value, so the running value is kept.
  ComponentIn(wanted, "a-logger").thread.reset();
  ComponentIn(wanted, "a-logger").runs_after.clear();

  EXPECT_THAT(
      TextsOf(MakePlan(RunningChain().catalogue(), wanted)),
      ElementsAre("stop robot/a-logger", "stop robot/filter", "stop robot/arm",
                  "remove robot/a-logger", "remove robot/filter", "configure robot/arm",
                  "create robot/filter (SimulatedArm of simulated_arm, which runs after arm)",
                  "create robot/a-logger (SimulatedArm of simulated_arm, which runs after filter)",
                  "start robot/arm", "start robot/filter", "start robot/a-logger"));
}

TEST(Plan, AProgramsOwnFollowerBlocksRecreation) {
  ComponentDescription own = test::Arm("own");
  own.class_name.clear();
  own.leader = "arm";
  CatalogBuilder builder;
  builder.Process("robot", {test::Arm(), own});
  SystemFile wanted = SystemOf(builder.catalogue(), "x").file;
  wanted.processes[0].components[0].configuration = R"({"noise":1})";

  EXPECT_THAT(MakePlan(builder.catalogue(), wanted).obstacles,
              ElementsAre("robot/own must be created again, because it runs after a component that "
                          "will be removed or created again; only the program of the process can "
                          "do this: stop that program first"));
}

TEST(Plan, StopsFirstAndClientsBeforeServers) {
  SystemFile wanted = DemoFile();
  wanted.processes[0].components[0].state = ComponentState::kSuspended;
  wanted.processes[1].components[0].state = ComponentState::kFinished;
  wanted.processes[1].components[1].configuration = R"({"noise":1})";
  wanted.connections.clear();

  EXPECT_THAT(TextsOf(PlanFromDemo(wanted)),
              ElementsAre("stop robot/spare", "suspend desk/teleoperation", "stop robot/arm",
                          "disconnect desk/teleoperation/Robot -> robot/arm/Control",
                          "configure robot/spare", "start robot/spare"));
}

TEST(Plan, StartsServersBeforeTheirClients) {
  CatalogBuilder empty;
  empty.Process("robot", {}).Process("desk", {});

  const Plan plan = MakePlan(empty.catalogue(), DemoFile());

  ASSERT_EQ(plan.steps.size(), 7U);
  EXPECT_EQ(ToString(plan.steps[4]), "start robot/arm");
  EXPECT_THAT(plan.steps[4].needs, IsEmpty());
  EXPECT_EQ(ToString(plan.steps[5]), "start desk/teleoperation");
  EXPECT_THAT(plan.steps[5].needs,
              ElementsAre(message::ConnectionEnds{test::kNeeded, test::kOffered}));
}

TEST(Plan, StartsNothingThatLacksAConnection) {
  ComponentDescription teleoperation = test::Teleoperation();
  teleoperation.state = ComponentState::kFinished;
  SystemFile wanted = DemoFile();
  const auto obstacle_of = [&](const CatalogBuilder& builder) {
    const Plan plan = MakePlan(builder.catalogue(), wanted);
    for (const std::string& text : TextsOf(plan)) EXPECT_NE(text, "start desk/teleoperation");
    return plan.obstacles.empty() ? "no obstacle" : plan.obstacles.back();
  };

  CatalogBuilder alone;
  alone.Process("desk", {teleoperation});
  EXPECT_EQ(obstacle_of(alone),
            "desk/teleoperation is not started, because it lacks its connection "
            "desk/teleoperation/Robot -> robot/arm/Control: process 'robot' is not available");

  CatalogBuilder misfit;
  ComponentDescription fake = test::FakeArm();
  misfit.Process("desk", {teleoperation}).Process("robot", {test::Arm(), test::Arm("spare"), fake});
  wanted.processes[1].components.push_back({"fake", "FakeArm", "simulated_arm", ""});
  wanted.connections[0].provided.component = "fake";
  EXPECT_THAT(obstacle_of(misfit), HasSubstr("missing write command 'MoveTo'"));
}

TEST(Plan, ReportsAFailedConnection) {
  CatalogBuilder builder = test::RunningDemo();
  builder.Connection(test::kNeeded, test::kOffered, ConnectionState::kFailed, "it does not fit");

  EXPECT_THAT(MakePlan(builder.catalogue(), DemoFile()).obstacles,
              ElementsAre("the connection desk/teleoperation/Robot -> robot/arm/Control has "
                          "failed: it does not fit"));
}

TEST(Plan, StepsNameTheProcessInstance) {
  CatalogBuilder empty;
  empty.Process("robot", {}).Process("desk", {});

  for (const PlanStep& step : MakePlan(empty.catalogue(), DemoFile()).steps) {
    const bool is_of_robot = step.process == "robot";
    EXPECT_EQ(step.instance, is_of_robot ? 1U : 2U) << ToString(step);
  }
}

TEST(Plan, AnEmptyLibraryMatchesAny) {
  SystemFile wanted = DemoFile();
  wanted.processes[1].components[0].library.clear();

  EXPECT_THAT(PlanFromDemo(wanted).steps, IsEmpty());
}

TEST(Plan, HandlesThousandsOfComponents) {
  constexpr int kComponents = 10'000;
  CatalogBuilder empty;
  empty.Process("robot", {});
  SystemFile wanted{.name = "large", .processes = {{"robot", {}}}};
  for (int i = 0; i < kComponents; ++i) {  // each component is a client of the next one
    const std::string name = "c" + std::to_string(i);
    const std::string next = "c" + std::to_string(i + 1);
    wanted.processes[0].components.push_back({name, "Arm", "arm", ""});
    if (i + 1 == kComponents) continue;
    wanted.connections.push_back({{"robot", name, "Robot"}, {"robot", next, "Control"}});
  }

  const Plan plan = MakePlan(empty.catalogue(), wanted);

  ASSERT_EQ(plan.steps.size(), 3U * kComponents - 1);
  EXPECT_EQ(ToString(plan.steps[2 * kComponents - 1]), "start robot/c9999");
  EXPECT_EQ(ToString(plan.steps.back()), "start robot/c0");
}

TEST(Plan, ReplacesAConnectionInOneStep) {
  SystemFile wanted = DemoFile();
  wanted.connections[0].provided = {"robot", "spare", "Control"};

  const Plan plan = PlanFromDemo(wanted);

  EXPECT_THAT(TextsOf(plan),
              ElementsAre("replace desk/teleoperation/Robot -> robot/spare/Control"));
  EXPECT_TRUE(plan.TakesAway());
}

TEST(Plan, BringsComponentsToTheirStates) {
  const auto steps = [](ComponentState now, ComponentState wanted) {
    ComponentDescription arm = test::Arm();
    arm.state = now;
    CatalogBuilder builder;
    builder.Process("robot", {arm});
    SystemFile file = SystemOf(builder.catalogue(), "x").file;
    file.processes[0].components[0].state = wanted;
    return TextsOf(MakePlan(builder.catalogue(), file));
  };
  using enum ComponentState;

  EXPECT_THAT(steps(kActive, kFinished), ElementsAre("stop robot/arm"));
  EXPECT_THAT(steps(kActive, kConstructed), ElementsAre("stop robot/arm"));
  EXPECT_THAT(steps(kActive, kSuspended), ElementsAre("suspend robot/arm"));
  EXPECT_THAT(steps(kSuspended, kActive), ElementsAre("start robot/arm"));
  EXPECT_THAT(steps(kFaulted, kActive), ElementsAre("start robot/arm"));
  EXPECT_THAT(steps(kFinished, kSuspended), ElementsAre("start robot/arm, then suspend it"));
  EXPECT_THAT(steps(kConstructed, kFinished), IsEmpty());
  EXPECT_THAT(steps(kFaulted, kFinished), IsEmpty());
}

TEST(Plan, ListsTheProcessesToStart) {
  CatalogBuilder builder;
  builder.Process("robot", {test::Arm()}, ProcessState::kLost);
  SystemFile wanted = DemoFile();
  wanted.processes[0].components[0].class_name.clear();

  const Plan plan = MakePlan(builder.catalogue(), wanted);

  EXPECT_THAT(plan.steps, IsEmpty());
  EXPECT_THAT(
      plan.obstacles,
      ElementsAre(
          "process 'desk' with 1 component is not available; start the program of this process",
          "process 'robot' with 2 components is not available; start this process: "
          "lcm --name robot"));
}

TEST(Plan, WaitsForAStartingProcess) {
  CatalogBuilder builder;
  builder.Process("robot", {test::Arm()}, ProcessState::kStarting)
      .Process("desk", {test::Teleoperation()});
  SystemFile wanted = DemoFile();
  wanted.processes[1].start = SystemFile::Start{};
  wanted.connections.clear();

  const Plan plan = MakePlan(builder.catalogue(), wanted);

  EXPECT_THAT(plan.steps, IsEmpty());
  EXPECT_THAT(plan.obstacles, ElementsAre("process 'robot' is starting (pid 1001); plan again when "
                                          "it has joined"));
}

TEST(Plan, ReportsDifferencesWithoutAPossibleStep) {
  ComponentDescription own = test::Arm("own");
  own.class_name.clear();
  CatalogBuilder builder;
  builder.Process("robot", {test::Arm(), own, test::FakeArm()})
      .Process("desk", {test::Teleoperation()});
  SystemFile wanted = SystemOf(builder.catalogue(), "x").file;
  auto& robot = wanted.processes[1];
  robot.components = {robot.components[0], robot.components[1], {"absent", "", "", ""}};
  robot.components[0].period = 0.002;
  wanted.connections.push_back({test::kNeeded, {"robot", "fake", "Control"}});

  const Plan plan = MakePlan(builder.catalogue(), wanted);

  ASSERT_EQ(plan.obstacles.size(), 4U) << testing::PrintToString(plan.obstacles);
  EXPECT_THAT(
      plan.obstacles[0],
      HasSubstr(
          "robot/own is not in the file, but the program of the process created the component"));
  EXPECT_THAT(plan.obstacles[1], HasSubstr("robot/arm does not have the period of the file "
                                           "(period 0.002 s -> 0.001 s)"));
  EXPECT_THAT(plan.obstacles[2], HasSubstr("robot/absent does not exist, and only the program of "
                                           "the process can create this component"));
  EXPECT_THAT(plan.obstacles[3], HasSubstr("missing write command 'MoveTo'"));
  EXPECT_EQ(plan.refusal, ErrorCode::kFailed);  // there are other obstacles besides the interfaces
}

/// The demo without its desk. The file has no connection for the desk.
struct StrictPlan : testing::Test {
  StrictPlan() {
    ComponentDescription teleoperation = test::Teleoperation();
    teleoperation.library = "teleoperation";
    teleoperation.state = ComponentState::kConstructed;
    catalogue = CatalogBuilder().Process("desk", {teleoperation}).catalogue();
    wanted = SystemOf(catalogue, "demo").file;
    wanted.processes[0].components[0].state = ComponentState::kActive;
    wanted.strict = true;
  }

  Catalogue catalogue;
  SystemFile wanted;
};

TEST_F(StrictPlan, RefusesToStartUnconnectedComponents) {
  const Plan plan = MakePlan(catalogue, wanted);

  EXPECT_THAT(plan.steps, IsEmpty());
  EXPECT_THAT(
      plan.obstacles,
      ElementsAre("desk/teleoperation is not started, because it lacks a connection for Robot, and "
                  "the file is strict; add the connection to the file, or leave out \"strict\""));
}

TEST_F(StrictPlan, StartsThemIfTheFileIsNotStrict) {
  wanted.strict = false;

  const Plan plan = MakePlan(catalogue, wanted);

  EXPECT_THAT(TextsOf(plan), ElementsAre("start desk/teleoperation"));
  EXPECT_FALSE(plan.steps[0].is_strict);
}

TEST_F(StrictPlan, LeavesTheCheckOfAnUnknownClassToItsProcess) {
  wanted.processes[0].components[0].class_name = "Another";

  const Plan plan = MakePlan(catalogue, wanted);

  ASSERT_FALSE(plan.steps.empty());
  EXPECT_EQ(ToString(plan.steps.back()), "start desk/teleoperation");
  EXPECT_TRUE(plan.steps.back().is_strict) << "its process refuses where it lacks something";
}

TEST_F(StrictPlan, RefusesToStartAReconfiguredComponent) {
  wanted.processes[0].components[0].configuration = R"({"gain":2})";

  const Plan plan = MakePlan(catalogue, wanted);

  EXPECT_THAT(TextsOf(plan), testing::Not(testing::Contains(HasSubstr("start"))));
  EXPECT_EQ(plan.obstacles.size(), 1U);
}

TEST_F(StrictPlan, IgnoresOptionalInterfaces) {
  ComponentDescription teleoperation = *catalogue.FindComponent("desk", "teleoperation");
  RequiredDescription optional = test::Robot();
  optional.optional = true;
  teleoperation.required.clear();
  teleoperation.required.push_back(optional);

  const Plan plan = MakePlan(CatalogBuilder().Process("desk", {teleoperation}).catalogue(), wanted);

  EXPECT_THAT(TextsOf(plan), ElementsAre("start desk/teleoperation"));
}

}  // namespace
}  // namespace tendon
