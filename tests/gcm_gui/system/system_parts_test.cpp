#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/system/diff_model.h>
#include <gcm_gui/system/snapshots.h>
#include <gcm_gui/system/system_parts.h>
#include <gtest/gtest.h>
#include <tendon/gcm/system/comparison.h>

#include <QAbstractItemModelTester>
#include <string>

#include "support/fakes.h"

namespace tendon::gui {
namespace {

/// Returns the system of "robot" with an arm, to which a desk is connected.
SystemFile ArmSystem() {
  SystemFile system;
  system.processes = {{.name = "robot", .components = {{.name = "arm", .class_name = "Arm"}}},
                      {.name = "desk", .components = {{.name = "hand", .class_name = "Hand"}}}};
  system.connections = {{{"desk", "hand", "Robot"}, {"robot", "arm", "Control"}, {}}};
  return system;
}

TEST(SystemParts, AMissingComponentIsAdded) {
  SystemFile without = ArmSystem();
  without.processes[0].components.clear();

  EXPECT_EQ(WithPartOf(without, ArmSystem(), "component robot/arm"), ArmSystem());
}

TEST(SystemParts, AMissingPartIsRemoved) {
  SystemFile without = ArmSystem();
  without.connections.clear();

  const auto differences =
      CompareSystems(ArmSystem(), without, StartComparison::kIgnore).differences;

  ASSERT_EQ(differences.size(), 1);
  EXPECT_EQ(WithPartOf(ArmSystem(), without, differences[0].what), without);
  EXPECT_EQ(WithPartOf(without, ArmSystem(), differences[0].what), ArmSystem());
}

TEST(SystemParts, AddingAProcessAddsItsConnections) {
  SystemFile without = ArmSystem();
  without.processes.pop_back();
  without.connections.clear();

  EXPECT_EQ(WithPartOf(without, ArmSystem(), "process desk"), ArmSystem());
}

TEST(SystemParts, ReplacesOnlyTheNamedPart) {
  SystemFile other = ArmSystem();
  other.processes[0].components[0].class_name = "Leg";
  other.connections.clear();

  const SystemFile merged = WithPartOf(ArmSystem(), other, "component robot/arm");

  EXPECT_EQ(merged.processes, other.processes);
  EXPECT_EQ(merged.connections, ArmSystem().connections);
}

TEST(Snapshots, KeepsTheLastFiftyStates) {
  Snapshots snapshots;
  for (int i = 0; i < 60; ++i) {
    SystemFile system;
    system.name = std::to_string(i);
    snapshots.add(i, system);
    snapshots.add(i + 1000, system);
  }

  EXPECT_EQ(snapshots.all().size(), Snapshots::kMax);
  EXPECT_EQ(snapshots.all().front().system.name, "10");
  EXPECT_EQ(snapshots.all().back().when, 59);
}

TEST(DiffModel, EachDifferenceHasASignAWordAndASentence) {
  DiffModel model;
  const QAbstractItemModelTester tester(&model);

  model.show({{{SystemDifference::Kind::kMissing, "component robot/arm", {}},
               {SystemDifference::Kind::kExtra, "component robot/leg", {}},
               {SystemDifference::Kind::kChanged, "component desk/hand", "class A -> B"}},
              29});

  ASSERT_EQ(model.rowCount(), 3);
  EXPECT_EQ(model.index(0).data(kGlyphRole), QStringLiteral("−"));
  EXPECT_EQ(model.index(1).data(kTrailRole), QStringLiteral("only running"));
  EXPECT_EQ(model.index(2).data(Qt::AccessibleTextRole),
            QStringLiteral("component desk/hand: changed class A -> B"));
}

TEST(PlanModel, EachStepShowsItsOutcome) {
  const CatalogueStore store;
  ScriptedReports reports;
  const SystemDocument document(store, reports);
  ScriptedPlans runner;
  PlanController restore(document, runner, reports);
  PlanModel model;
  const QAbstractItemModelTester tester(&model);
  SystemFile wanted = ArmSystem();
  for (auto& process : wanted.processes) process.start = SystemFile::Start{};

  restore.preview(wanted, QStringLiteral("arm.json"));
  model.show(restore);
  ASSERT_GE(model.rowCount(), 2);
  const int steps = static_cast<int>(restore.plan().steps.size());
  const int first = model.rowCount() - steps;  // the obstacles come before the steps
  EXPECT_EQ(model.row(first).kind, PlanLine::Kind::kWaiting);

  restore.execute(AfterError::kStop);
  runner.progress(1, {.state = StepOutcome::State::kDone, .reason = {}});
  runner.progress(2, {.state = StepOutcome::State::kFailed, .reason = "it does not fit"});
  model.show(restore);
  EXPECT_EQ(model.row(first).kind, PlanLine::Kind::kDone);
  EXPECT_EQ(model.row(first + 1).kind, PlanLine::Kind::kFailed);
  EXPECT_TRUE(model.index(first + 1)
                  .data(Qt::AccessibleTextRole)
                  .toString()
                  .endsWith("it does not fit, failed"));
}

TEST(DiffModel, TheSummaryCountsAll) {
  const SystemComparison comparison{{{SystemDifference::Kind::kMissing, "process desk", {}}}, 29};

  EXPECT_EQ(SummaryOf(comparison), "= 29   + 0 only running   − 1 missing   ~ 0 changed");
}

}  // namespace
}  // namespace tendon::gui
