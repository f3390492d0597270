#include <gmock/gmock.h>
#include <tendon/gcm/system/comparison.h>
#include <tendon/gcm/system/running_system.h>
#include <tests/core/gcm/system/running_catalogue.h>

namespace tendon {
namespace {

using Difference = SystemDifference::Kind;

SystemFile Demo() { return SystemOf(test::RunningDemo().catalogue(), "demo").file; }

std::vector<SystemDifference> DifferencesFromDemo(const SystemFile& second) {
  return CompareSystems(Demo(), second, StartComparison::kCompare).differences;
}

TEST(SystemComparison, ASystemEqualsItself) {
  const SystemComparison comparison = CompareSystems(Demo(), Demo(), StartComparison::kCompare);

  EXPECT_TRUE(comparison.differences.empty());
  EXPECT_EQ(comparison.equal, 6U);  // two processes, three components and a connection are equal
}

TEST(SystemComparison, ListsObjectsOfOnlyOneSystem) {
  SystemFile second = Demo();
  second.processes[1].components.erase(second.processes[1].components.begin());
  second.processes.push_back({"new", {{"host", "HostMonitor", "", ""}}});
  second.connections.clear();

  EXPECT_THAT(
      DifferencesFromDemo(second),
      testing::ElementsAre(
          SystemDifference{Difference::kMissing, "component robot/arm", ""},
          SystemDifference{Difference::kExtra, "process new", ""},
          SystemDifference{Difference::kExtra, "component new/host", ""},
          SystemDifference{Difference::kMissing,
                           "connection desk/teleoperation/Robot -> robot/arm/Control", ""}));
}

TEST(SystemComparison, DescribesAChangedComponent) {
  SystemFile second = Demo();
  auto& arm = second.processes[1].components[0];
  arm.class_name = "LegacyArm";
  arm.configuration = R"({"gain":1})";
  arm.period = 0.5;
  arm.state = ComponentState::kSuspended;

  EXPECT_THAT(DifferencesFromDemo(second),
              testing::ElementsAre(SystemDifference{
                  Difference::kChanged, "component robot/arm",
                  "class SimulatedArm -> LegacyArm; configuration {\"noise\":0} -> "
                  "{\"gain\":1}; period "
                  "0.001 s -> 0.5 s; state active -> suspended"}));
}

TEST(SystemComparison, DescribesAChangedConnection) {
  SystemFile second = Demo();
  second.connections[0].provided = {"robot", "spare", "Control"};

  EXPECT_THAT(DifferencesFromDemo(second),
              testing::ElementsAre(
                  SystemDifference{Difference::kChanged, "connection desk/teleoperation/Robot",
                                   "to robot/arm/Control -> robot/spare/Control"}));
}

TEST(SystemComparison, IgnoresIrrelevantDifferences) {
  SystemFile first = Demo();
  SystemFile second = Demo();
  second.name = "other";
  second.comment = "other";
  second.layout = {{"robot/arm", {1, 2}}};
  auto& arm = second.processes[1].components[0];
  arm.period = 0.0;
  arm.library.clear();
  arm.thread.emplace();
  first.processes[1].components[0].state = ComponentState::kFinished;
  arm.state = ComponentState::kConstructed;
  first.processes[1].components[0].configuration = R"({"a": 1, "b": 2})";
  arm.configuration = R"({"b":2,"a":1})";

  EXPECT_TRUE(CompareSystems(first, second, StartComparison::kCompare).differences.empty());
}

TEST(SystemComparison, DescribesChangedThreadsAndLeaders) {
  SystemFile first = Demo();
  SystemFile second = Demo();
  auto& arm = first.processes[1].components[0];
  auto& other = second.processes[1].components[0];
  const auto how = [&] {
    const auto differences = CompareSystems(first, second, StartComparison::kIgnore).differences;
    return differences.empty() ? std::string() : differences[0].how;
  };

  arm.thread.emplace().lock_memory = true;
  EXPECT_EQ(how(), "");  // the second file does not specify it
  other.thread.emplace();
  EXPECT_THAT(how(), testing::StartsWith("thread {"));
  EXPECT_THAT(how(), testing::HasSubstr("\"lock_memory\":true"));
  other.thread = arm.thread;
  EXPECT_EQ(how(), "");
  arm.runs_after = "spare";
  EXPECT_EQ(how(), "runs_after spare -> none");
  other.thread.reset();
  EXPECT_EQ(how(), "");
  other.runs_after = "spare";
  EXPECT_EQ(how(), "");
}

TEST(SystemComparison, ComparesTheStarterOnlyBetweenFiles) {
  SystemFile first = Demo();
  const SystemFile second = Demo();
  first.processes[1].start = SystemFile::Start{RestartPolicy::kOnFailure};

  const auto differences = CompareSystems(first, second, StartComparison::kCompare).differences;
  ASSERT_EQ(differences.size(), 1U);
  EXPECT_EQ(differences[0].what, "process " + first.processes[1].name);
  EXPECT_EQ(differences[0].how, "start by the GCM (restart on-failure) -> by others");
  EXPECT_TRUE(CompareSystems(first, second, StartComparison::kIgnore).differences.empty());
}

TEST(SystemComparison, ComparesUnreadableConfigurationsAsText) {
  const std::string deep(100'000, '[');

  EXPECT_TRUE(IsSameJson(deep, deep));
  EXPECT_FALSE(IsSameJson(deep, deep + "[" + std::string(deep.size() + 1, ']')));
  EXPECT_FALSE(IsSameJson("", "{}"));
  EXPECT_TRUE(IsSameJson(R"({"a": "\u00e9"})", "{\"a\":\"\xc3\xa9\"}"));
}

TEST(SystemComparison, AFaultedComponentIsADifference) {
  SystemFile second = Demo();
  second.processes[1].components[0].state = ComponentState::kFaulted;

  EXPECT_THAT(DifferencesFromDemo(second),
              testing::ElementsAre(SystemDifference{Difference::kChanged, "component robot/arm",
                                                    "state active -> faulted"}));
}

}  // namespace
}  // namespace tendon
