#include <gcm_gui/inspector/cycle_figures.h>
#include <gcm_gui/inspector/interfaces_model.h>
#include <gcm_gui/inspector/thread_facts.h>
#include <gcm_gui/inspector/values_model.h>
#include <gcm_gui/models/row_roles.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <chrono>
#include <limits>
#include <memory>
#include <vector>

#include "support/fakes.h"
#include "support/sample_system.h"

namespace tendon::gui {
namespace {

TEST(ValuesModel, ShowsEveryNumberOnceItArrives) {
  ValuesModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  ScriptedSignals source;
  QObject::connect(&source, &SignalSource::valuesArrived, &model, &ValuesModel::showValues);
  const Catalogue catalogue = LookSystem(0).catalogue();
  model.show("robot/arm", catalogue.FindComponent("robot", "arm"), StaleReason::kNone);
  EXPECT_EQ(model.rowCount(), 3);
  EXPECT_EQ(model.index(0, 0).data(), "Joints");
  EXPECT_EQ(model.index(0, 1).data(), "…");
  EXPECT_EQ(model.columns(), (QSet<QString>{"robot/arm/state.Joints", "robot/arm/state.Cycle",
                                            "robot/arm/state.CycleSummary"}));

  source.send("robot/arm/state.Joints", test::JointStateSchema(3), {0.5, 0, 0, 1, 0, 0});

  EXPECT_EQ(model.rowCount(), 8);
  EXPECT_EQ(model.index(0, 0).data(), "Joints.position[0]");
  EXPECT_EQ(model.index(0, 1).data(), "0.5000");
  EXPECT_EQ(model.index(3, 1).data(kUnitRole), "rad/s");
  EXPECT_EQ(model.index(3, 0).data(kPathRole), "robot/arm/state.Joints.velocity[0]");
  EXPECT_EQ(model.index(6, 0).data(), "Cycle");
}

/// The values of the arm, with a clock that the test advances.
class ValuesModelTest : public ::testing::Test {
 protected:
  ValuesModelTest() {
    model_.show("robot/arm", catalogue_.FindComponent("robot", "arm"), StaleReason::kNone);
    clock_.Advance(std::chrono::seconds(1));
    model_.await();
  }

  void Pass(std::chrono::nanoseconds time) {
    clock_.Advance(time);
    model_.tick();
  }
  /// Sends the newest row; `rows` is the number of rows so far.
  void Send(std::uint64_t rows, const std::vector<double>& values) {
    model_.showValues(kJoints, {.fields = shape_,
                                .values = ExactValues(values),
                                .text = {},
                                .picture = {},
                                .rows = rows,
                                .time = clock_.Now().time_since_epoch().count()});
  }
  [[nodiscard]] QVariant Value(int row, int role = Qt::DisplayRole) const {
    return model_.index(row, ValuesModel::kValue).data(role);
  }
  [[nodiscard]] QString Detail() const { return model_.index(0, 0).data(kDetailRole).toString(); }

  const QString kJoints = "robot/arm/state.Joints";
  const NumericFieldList shape_ =
      std::make_shared<const std::vector<NumericField>>(NumericFields(test::JointStateSchema(1)));
  const Catalogue catalogue_ = LookSystem(0).catalogue();
  ManualClock clock_;
  ValuesModel model_{nullptr, clock_};
  QAbstractItemModelTester tester_{&model_, QAbstractItemModelTester::FailureReportingMode::Fatal};
};

TEST_F(ValuesModelTest, AChangedValueIsFreshForHalfASecond) {
  Send(1, {0.5, 0});
  EXPECT_FALSE(Value(0, kFreshRole).toBool()) << "it has only just come";

  Send(2, {0.6, 0});
  EXPECT_TRUE(Value(0, kFreshRole).toBool());
  EXPECT_FALSE(Value(1, kFreshRole).toBool());

  QSignalSpy changed(&model_, &QAbstractItemModel::dataChanged);
  Pass(ValuesModel::kFresh);
  EXPECT_FALSE(Value(0, kFreshRole).toBool());
  EXPECT_EQ(changed.count(), 1) << "it is drawn anew";
}

TEST_F(ValuesModelTest, TheTooltipShowsTheExactValue) {
  Send(1, {0.1 + 0.2, 2});

  EXPECT_EQ(Value(0), "0.3000");
  EXPECT_EQ(Value(0, Qt::ToolTipRole), kJoints + ".position[0]\n0.30000000000000004 rad");
  EXPECT_EQ(Value(1, Qt::ToolTipRole), kJoints + ".velocity[0]");
}

TEST_F(ValuesModelTest, ARepeatedNanIsNoChange) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  Send(1, {none, 0.0});
  Send(2, {none, -0.0});

  EXPECT_EQ(Value(0), "nan");
  EXPECT_FALSE(Value(0, kFreshRole).toBool());
  EXPECT_TRUE(Value(1, kFreshRole).toBool()) << "it has another sign";
}

TEST_F(ValuesModelTest, AColumnShowsItsRateAndLaterItsAge) {
  Send(1, {0, 0});
  EXPECT_EQ(Detail(), "");
  Pass(std::chrono::seconds(1));
  Send(1001, {0, 0});
  EXPECT_EQ(Detail(), "1000 Hz");
  EXPECT_FALSE(Value(0, kStaleRole).toBool());

  Pass(std::chrono::seconds(12));
  EXPECT_EQ(Detail(), "12 s old");
  EXPECT_TRUE(Value(0, kStaleRole).toBool());

  Send(1002, {0, 0});
  EXPECT_FALSE(Value(0, kStaleRole).toBool());
}

TEST_F(ValuesModelTest, ATimedOutColumnCanBeRequestedAgain) {
  EXPECT_EQ(Value(0).toString(), "…");
  EXPECT_EQ(model_.askAgain(0), "");
  Pass(ValuesModel::kReplyTimeout);
  EXPECT_EQ(Value(0).toString(), "no reply in 1 s · ask again");
  EXPECT_TRUE(Value(0, kAccentRole).toBool());

  EXPECT_EQ(model_.askAgain(0), kJoints);
  EXPECT_EQ(Value(0).toString(), "…");
  EXPECT_EQ(Value(1).toString(), "no reply in 1 s · ask again") << "another column";

  Send(1, {0.5, 0});
  EXPECT_EQ(Value(0).toString(), "0.5000");
  EXPECT_EQ(model_.askAgain(0), "");
}

TEST_F(ValuesModelTest, ARefusedColumnShowsTheReasonAndCanBeRetried) {
  model_.showRefusal(kJoints, "it has no such column");
  EXPECT_EQ(Value(0).toString(), "it has no such column · ask again");
  EXPECT_EQ(model_.index(0, 0).data(Qt::ToolTipRole), "it has no such column");
  EXPECT_FALSE(model_.isNumber(0));

  EXPECT_EQ(model_.askAgain(0), kJoints);
  EXPECT_EQ(Value(0).toString(), "…");

  model_.showRefusal(kJoints, "it has no such column");
  Send(1, {0.5, 0});
  EXPECT_EQ(Value(0).toString(), "0.5000");
  EXPECT_TRUE(model_.isNumber(0));
}

TEST_F(ValuesModelTest, HiddenValuesDoNotTimeOut) {
  model_.awaitNothing();
  Pass(ValuesModel::kReplyTimeout);
  model_.await();
  EXPECT_EQ(Value(0).toString(), "…");

  Pass(ValuesModel::kReplyTimeout);
  EXPECT_EQ(Value(0).toString(), "no reply in 1 s · ask again");
}

TEST_F(ValuesModelTest, AReturnedProcessGetsANewTimeout) {
  model_.show("robot/arm", catalogue_.FindComponent("robot", "arm"), StaleReason::kLost);
  Pass(10 * ValuesModel::kReplyTimeout);

  model_.show("robot/arm", catalogue_.FindComponent("robot", "arm"), StaleReason::kNone);

  EXPECT_EQ(Value(0).toString(), "…");
}

TEST_F(ValuesModelTest, TheAccessibleTextIncludesTheRate) {
  Send(1, {0, 0});
  Pass(std::chrono::seconds(1));
  Send(1001, {0, 0});

  EXPECT_TRUE(Value(0, Qt::AccessibleTextRole).toString().endsWith(", 1000 Hz"));
}

TEST_F(ValuesModelTest, ALostProcessDoesNotTimeOut) {
  model_.show("robot/arm", catalogue_.FindComponent("robot", "arm"), StaleReason::kLost);
  Pass(ValuesModel::kReplyTimeout);

  EXPECT_EQ(Value(0).toString(), "…");
}

TEST_F(ValuesModelTest, ValuesOfASuspendedComponentShowReasonAndAge) {
  Send(1, {0, 0.116});
  Pass(std::chrono::seconds(1));
  Send(1001, {0, 0.116});
  EXPECT_FALSE(Value(1, kStaleRole).toBool());

  model_.show("robot/arm", catalogue_.FindComponent("robot", "arm"), StaleReason::kSuspended);
  EXPECT_FALSE(Value(1, kStaleRole).toBool()) << "its last rows may still be on their way";
  Pass(std::chrono::seconds(12));

  EXPECT_TRUE(Value(1, kStaleRole).toBool());
  EXPECT_EQ(Detail(), "suspended · 12 s old");
  EXPECT_TRUE(Value(0, Qt::AccessibleTextRole).toString().endsWith(", suspended · 12 s old"));

  model_.show("robot/arm", catalogue_.FindComponent("robot", "arm"), StaleReason::kNone);
  Send(1002, {0, 0});
  EXPECT_FALSE(Value(1, kStaleRole).toBool());
}

TEST(ThreadFacts, DescribeTheThreadAndItsCycleTimes) {
  ScriptedSignals source;
  CycleFigures figures(source);
  figures.show("robot/arm");
  SendSummary(source, "robot/arm", {878, 1.139e-3, 35e-6, 3e-3, 52e-3, 42e-6});
  ComponentDescription arm;
  arm.period = 1e-3;
  arm.thread = {{.policy = SchedulingPolicy::kFifo, .priority = 80, .cpus = {2, 3}}};
  const auto value = [&](const QString& name) {
    for (const Property& fact : ThreadFacts(arm, figures)) {
      if (fact.name == name) return fact.value;
    }
    return QString();
  };

  EXPECT_EQ(value("Thread"), "its own");
  EXPECT_EQ(value("Scheduling"), "FIFO 80");
  EXPECT_EQ(value("Processors"), "2, 3");
  EXPECT_EQ(value("Wanted period"), "1 ms · 1 kHz");
  EXPECT_EQ(value("Starts late by"), "35.0 µs");
  EXPECT_EQ(value("Latest start"), "52.00 ms");
  arm.leader = "controller";
  EXPECT_EQ(value("Thread"), "the thread of controller");
  EXPECT_EQ(value("Scheduling"), "");
}

TEST(InterfacesModel, ShowsMembersWithTypesAndPeers) {
  InterfacesModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);

  model.show(LookSystem(0).catalogue(), "robot", "controller");

  EXPECT_EQ(model.row(0).name, "Arm");
  EXPECT_EQ(model.row(0).value, "connected");
  EXPECT_EQ(model.row(1).kind, InterfaceRow::Kind::kPeer);
  EXPECT_EQ(model.row(1).name, "← arm/Drives");
  EXPECT_EQ(model.row(2).name, "SetTorques");
  EXPECT_EQ(model.row(2).types, "JointTorques");
}

TEST(InterfacesModel, APeerInAnotherProcessShowsTheProcess) {
  InterfacesModel model;
  SystemBuilder system = LookSystem(0);
  system.Connect({"desk", "teleoperation", "Robot"}, {"robot", "controller", "Control"});

  model.show(system.catalogue(), "desk", "teleoperation");

  EXPECT_EQ(model.row(1).name, "← controller/Control");
  EXPECT_EQ(model.row(1).types, "robot");
  EXPECT_EQ(model.row(1).path, "robot/controller/Control");
}

TEST(InterfacesModel, AProvidedInterfaceListsItsClients) {
  InterfacesModel model;

  model.show(LookSystem(0).catalogue(), "robot", "arm");

  EXPECT_EQ(model.row(0).value, "1 client");
  EXPECT_EQ(model.row(1).name, "→ controller/Arm");
  EXPECT_EQ(model.row(1).required, (InterfaceName{"robot", "controller", "Arm"}));
}

TEST(CycleFigures, ReportsTheLastSecondAndSkippedCycles) {
  ScriptedSignals source;
  CycleFigures figures(source);
  figures.show("robot/arm");
  EXPECT_EQ(source.watched(),
            (QSet<QString>{"robot/arm/state.Cycle", "robot/arm/state.CycleSummary"}));

  source.send("robot/arm/state.Cycle", CycleSchema(), {54e-6, 2e-6, 38e-6, 4});
  SendSummary(source, "robot/arm", {878, 1.139e-3, 35e-6, 3e-3, 52e-3, 42e-6});

  EXPECT_EQ(figures.skipped(), 4u);
  ASSERT_TRUE(figures.lastSecond().has_value());
  EXPECT_DOUBLE_EQ(figures.lastSecond()->period, 1.139e-3);
  EXPECT_DOUBLE_EQ(figures.lastSecond()->late, 35e-6);
  EXPECT_DOUBLE_EQ(figures.lastSecond()->later, 3e-3);
  EXPECT_DOUBLE_EQ(figures.lastSecond()->latest, 52e-3);
  EXPECT_DOUBLE_EQ(figures.lastSecond()->compute, 42e-6);
}

TEST(CycleFigures, AreEmptyDuringTheFirstSecond) {
  ScriptedSignals source;
  CycleFigures figures(source);
  figures.show("robot/arm");

  SendSummary(source, "robot/arm", {});

  EXPECT_FALSE(figures.lastSecond().has_value());
  EXPECT_FALSE(figures.skipped().has_value());
}

TEST(CycleFigures, ReleaseThePreviousComponent) {
  ScriptedSignals source;
  CycleFigures figures(source);
  figures.show("robot/arm");

  figures.show({});

  EXPECT_TRUE(source.watched().isEmpty());
  EXPECT_FALSE(figures.skipped().has_value());
}

}  // namespace
}  // namespace tendon::gui
