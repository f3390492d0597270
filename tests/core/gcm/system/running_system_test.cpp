#include <gmock/gmock.h>
#include <tendon/gcm/system/running_system.h>
#include <tests/core/gcm/system/running_catalogue.h>

namespace tendon {
namespace {

using test::CatalogBuilder;

SystemFile ReadBack(const SystemFile& system) {
  const auto text = SystemFileText(system);
  EXPECT_TRUE(text);
  const auto again = ParseSystemFile(*text, "saved");
  EXPECT_TRUE(again) << again.error().message;
  return again ? *again : SystemFile();
}

TEST(RunningSystem, IsDescribedCompletely) {
  const auto [file, loose] = SystemOf(test::RunningDemo().catalogue(), "demo");

  EXPECT_EQ(file.name, "demo");
  ASSERT_EQ(file.processes.size(), 2U);
  EXPECT_EQ(file.processes[0].name, "desk");
  const auto* arm = file.FindComponent("robot", "arm");
  ASSERT_NE(arm, nullptr);
  EXPECT_EQ(arm->class_name, "SimulatedArm");
  EXPECT_EQ(arm->library, "simulated_arm");
  EXPECT_EQ(arm->configuration, R"({"noise":0})");
  EXPECT_EQ(arm->period, 0.001);
  EXPECT_EQ(arm->state, ComponentState::kActive);
  EXPECT_EQ(file.connections,
            (std::vector<SystemFile::Connection>{{test::kNeeded, test::kOffered}}));
  EXPECT_TRUE(loose.empty());
  EXPECT_EQ(ReadBack(file), file);
}

TEST(RunningSystem, CanBeReadBackInAnyState) {
  ComponentDescription faulted = test::Arm("faulted");
  faulted.state = ComponentState::kFaulted;
  ComponentDescription ready = test::Arm("ready");
  ready.state = ComponentState::kReady;
  ComponentDescription own = test::Arm("own");
  own.class_name.clear();
  CatalogBuilder builder;
  builder.Process("robot", {faulted, ready, own});

  const SystemFile file = ReadBack(SystemOf(builder.catalogue(), "x").file);

  EXPECT_EQ(file.FindComponent("robot", "faulted")->state, ComponentState::kActive);
  EXPECT_EQ(file.FindComponent("robot", "ready")->state, ComponentState::kConstructed);
  EXPECT_EQ(file.FindComponent("robot", "own")->class_name, "");
}

TEST(RunningSystem, ReportsOmittedAbsentObjects) {
  CatalogBuilder builder;
  builder.Process("robot", {test::Arm()}, ProcessState::kLost)
      .Process("gcm", {})
      .Process("desk", {test::Teleoperation()})
      .Connection(test::kNeeded, test::kOffered);

  const RunningSystem running = SystemOf(builder.catalogue(), "x");

  ASSERT_EQ(running.file.processes.size(), 1U);
  EXPECT_TRUE(running.file.connections.empty());
  EXPECT_THAT(
      running.LeftOut(),
      testing::ElementsAre("desk/teleoperation/Robot -> robot/arm/Control is left out, because "
                           "robot/arm does not exist"));
}

TEST(RunningSystem, KeepsDataThatOnlyTheFileHas) {
  SystemFile former = SystemOf(test::RunningDemo().catalogue(), "demo").file;
  former.comment = "of the lab";
  former.layout = {{"robot/arm", {1, 2}}, {"robot/gone", {3, 4}}};
  former.connections[0].comment = "by hand";
  for (auto& process : former.processes) {
    process.comment = "here";
    process.start = SystemFile::Start{RestartPolicy::kOnFailure};
    for (auto& component : process.components) {
      component.comment = "mine";
    }
  }
  RunningSystem running = SystemOf(test::RunningDemo().catalogue(), "demo");
  SystemFile& saved = running.file;
  saved.processes[1].components[1].class_name = "Other";

  EXPECT_THAT(KeepFrom(former, running), testing::IsEmpty());

  EXPECT_EQ(saved.comment, "of the lab");
  EXPECT_EQ(saved.layout.size(), 1U);
  EXPECT_EQ(saved.connections[0].comment, "by hand");
  EXPECT_EQ(saved.processes[0].comment, "here");
  EXPECT_EQ(saved.processes[0].start, SystemFile::Start{RestartPolicy::kOnFailure});
  EXPECT_EQ(saved.FindComponent("robot", "arm")->comment, "mine");
}

TEST(RunningSystem, IncludesThreadsOfRecreatableComponents) {
  const ThreadOptions fifo{.policy = SchedulingPolicy::kFifo, .priority = 40, .cpus = {900}};
  ComponentDescription arm = test::Arm();
  arm.thread = {fifo};
  ComponentDescription filter = test::Arm("filter");
  filter.thread = {ThreadOptions()};
  filter.leader = "arm";
  ComponentDescription own = filter;
  own.name = "own";
  own.class_name.clear();
  CatalogBuilder builder;
  builder.Process("robot", {arm, filter, own});

  const SystemFile file = SystemOf(builder.catalogue(), "x").file;

  EXPECT_EQ(file.FindComponent("robot", "arm")->thread, fifo);
  EXPECT_EQ(file.FindComponent("robot", "arm")->runs_after, "");
  EXPECT_EQ(file.FindComponent("robot", "filter")->thread, ThreadOptions());
  EXPECT_EQ(file.FindComponent("robot", "filter")->runs_after, "arm");
  // The filter has the period of the arm.
  EXPECT_EQ(file.FindComponent("robot", "filter")->period, 0.0);
  EXPECT_FALSE(file.FindComponent("robot", "own")->tells_thread());
  EXPECT_EQ(ReadBack(file), file);
  EXPECT_THAT(*SystemFileText(file), testing::HasSubstr(R"("thread": {
            "policy": "normal"
          },
          "runs_after": "arm")"));
}

TEST(RunningSystem, IncludesAbsentProcessesOnRequest) {
  CatalogBuilder builder = test::RunningDemo();
  builder.Process("robot", {test::Arm()}, ProcessState::kLost);

  EXPECT_EQ(SystemOf(builder.catalogue(), "x").file.FindProcess("robot"), nullptr);
  const RunningSystem whole = SystemOf(builder.catalogue(), "x", AbsentProcesses::kIncluded);
  EXPECT_NE(whole.file.FindComponent("robot", "arm"), nullptr);
  EXPECT_EQ(whole.file.connections.size(), 1U);
}

/// Returns the running demo system without the process `process`.
RunningSystem RunningWithout(const std::string& process, CatalogBuilder& builder) {
  if (process != "robot") builder.Process("robot", {test::Arm(), test::Arm("spare")});
  if (process != "desk") builder.Process("desk", {test::Teleoperation()});
  return SystemOf(builder.catalogue(), "demo");
}

TEST(RunningSystem, KeepsAbsentProcessesOfTheFile) {
  SystemFile former = SystemOf(test::RunningDemo().catalogue(), "demo").file;
  former.connections[0].comment = "by hand";
  former.layout = {{"robot/arm", {1, 2}}, {"desk/teleoperation", {3, 4}}};
  former.processes[1].components[0].thread.emplace().lock_memory = true;
  for (const std::string absent : {"desk", "robot"}) {
    CatalogBuilder builder;
    RunningSystem saved = RunningWithout(absent, builder);
    // The connection waits for robot.
    if (absent == "robot") saved.loose.push_back({test::kNeeded, test::kOffered});

    const auto kept = KeepFrom(former, saved);

    const std::string count = absent == "robot" ? "2 components" : "1 component";
    EXPECT_THAT(kept,
                testing::ElementsAre("process '" + absent +
                                     "' is not available now: kept as in the file, with " + count));
    EXPECT_EQ(*saved.file.FindProcess(absent), *former.FindProcess(absent));
    EXPECT_EQ(saved.file.connections, former.connections);
    EXPECT_EQ(saved.file.layout, former.layout);
    EXPECT_THAT(saved.LeftOut(), testing::IsEmpty());
    EXPECT_EQ(ReadBack(saved.file), saved.file);
  }
}

TEST(RunningSystem, OmitsConnectionsToRemovedComponents) {
  const SystemFile former = SystemOf(test::RunningDemo().catalogue(), "demo").file;
  CatalogBuilder builder;
  builder.Process("robot", {test::Arm("spare")});
  RunningSystem saved = SystemOf(builder.catalogue(), "demo");

  KeepFrom(former, saved);

  EXPECT_TRUE(saved.file.connections.empty());
  EXPECT_THAT(
      saved.LeftOut(),
      testing::ElementsAre("desk/teleoperation/Robot -> robot/arm/Control is left out, because "
                           "robot/arm does not exist"));
  EXPECT_EQ(ReadBack(saved.file), saved.file);
}

}  // namespace
}  // namespace tendon
