#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/activity/problems_model.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/text.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include "support/sample_system.h"

namespace tendon::gui {
namespace {

const InterfaceName kRobot{"desk", "teleoperation", "Robot"};
const InterfaceName kControl{"robot", "controller", "Control"};

Action Connecting() {
  Action action;
  action.required = kRobot;
  action.provided = kControl;
  return action;
}

TEST(ActivityModel, ShowsTheNewestActionFirstWithItsCommandLine) {
  ActivityModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  Action disconnecting;
  disconnecting.verb = Action::Verb::kDisconnect;
  disconnecting.required = kRobot;

  model.begin(Connecting());
  model.begin(disconnecting);

  EXPECT_EQ(model.command(0), "gcm disconnect desk/teleoperation/Robot");
  EXPECT_EQ(model.command(1), "gcm connect desk/teleoperation/Robot robot/controller/Control");
}

TEST(ActivityModel, NothingBeforeAPlanCanBeUndoneAlone) {
  ActivityModel model;
  model.finish(model.begin(Connecting()), 0.1, {});
  Action apply;
  apply.verb = Action::Verb::kApply;
  apply.argument = "lab.gcm.json";
  apply.file = "/home/anna/my lab's/lab.gcm.json";
  const auto id = model.begin(apply);
  EXPECT_TRUE(model.canUndo(1));
  model.finish(id, 2.0, {});

  EXPECT_EQ(model.command(0), R"(gcm apply '/home/anna/my lab'\''s/lab.gcm.json')");
  EXPECT_EQ(model.data(model.index(0, 0), kObjectRole), "lab.gcm.json");
  EXPECT_FALSE(model.canUndo(0));
  EXPECT_FALSE(model.canUndo(1)) << "the GCM would take back a step of the plan";

  apply.file.clear();
  model.begin(apply);
  EXPECT_EQ(model.command(0), "") << "what was before is in no file";
}

TEST(ActivityModel, OnlyTheNewestDoneStepCanBeUndone) {
  ActivityModel model;
  const auto first = model.begin(Connecting());
  EXPECT_FALSE(model.canUndo(0));  // the action has not ended yet
  model.finish(first, 0.038, {});
  const auto second = model.begin(Connecting());
  model.finish(second, 0.1, "robot/controller does not run");

  EXPECT_FALSE(model.canUndo(0));  // the action was refused
  EXPECT_TRUE(model.canUndo(1));
}

TEST(ActivityModel, MarksAnUndoneStepAndAllowsTheNextUndo) {
  ActivityModel model;
  Action other = Connecting();
  other.required.interface = "Other";
  model.finish(model.begin(other), 0.1, {});
  model.finish(model.begin(Connecting()), 0.1, {});
  Action undo;
  undo.verb = Action::Verb::kUndo;
  const auto id = model.begin(undo);
  model.finish(id, 0.02, {});

  model.markUndone(id, Connecting());

  EXPECT_TRUE(model.action(1).undone);
  EXPECT_TRUE(model.canUndo(2));
  EXPECT_EQ(model.action(0).required, kRobot);
}

TEST(ActivityModel, LifecycleCommandsExceptRestartCanBeUndone) {
  ActivityModel model;
  Action stop;
  stop.verb = Action::Verb::kLifecycle;
  stop.lifecycle_verb = LifecycleVerb::kStop;
  stop.component = "robot/arm";
  Action restart = stop;
  restart.lifecycle_verb = LifecycleVerb::kRestart;
  model.finish(model.begin(stop), 0.1, {});
  model.finish(model.begin(restart), 0.1, {});

  EXPECT_EQ(model.command(0), "gcm restart robot/arm");
  EXPECT_EQ(model.command(1), "gcm stop robot/arm");
  EXPECT_EQ(model.index(1, 0).data(kObjectRole), "robot/arm");
  EXPECT_FALSE(model.canUndo(0));
  EXPECT_TRUE(model.canUndo(1));

  model.markUndone(0, restart);
  EXPECT_FALSE(model.action(0).undone);
  model.markUndone(0, stop);
  EXPECT_TRUE(model.action(1).undone);
}

TEST(ActivityModel, ShowsARefusalInItsRow) {
  ActivityModel model;
  QSignalSpy finished(&model, &ActivityModel::finished);

  model.finish(model.begin(Connecting()), 0.01, "does not fit");

  EXPECT_EQ(finished.count(), 1);
  EXPECT_TRUE(model.index(0, 0).data(Qt::AccessibleTextRole).toString().contains("does not fit"));
}

TEST(ProblemsModel, ListsLostProcessesFaultsAndFailedConnections) {
  ProblemsModel model;
  QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  SystemBuilder system = LookSystem(1);
  ComponentDescription arm = *system.catalogue().FindComponent("robot", "arm");
  arm.state = ComponentState::kFaulted;
  arm.fault = "joint 3 is out of range";
  system.Component("robot", arm);
  system.Connect({"desk", "view", "Host"}, {"desk", "host_monitor", "state"},
                 ConnectionState::kFailed, "no reply in 2 s");

  model.update(system.catalogue());

  ASSERT_EQ(model.rowCount(), 4);
  EXPECT_EQ(model.row(0).text, "desk/view/Host is not connected: no reply in 2 s");
  EXPECT_EQ(model.row(1).text, "robot/arm is faulted: joint 3 is out of range");
  EXPECT_EQ(model.row(2).text, "vision is lost: its connection broke");
  EXPECT_EQ(model.row(3).text, "desk/teleoperation waits for Robot: not connected");
}

TEST(ProblemsModel, AlignsProblemsWithAndWithoutATime) {
  const auto times = [](std::int64_t lost_since) {
    ProblemsModel model;
    model.update(LookSystem(lost_since).catalogue());
    QStringList all;
    for (int row = 0; row < model.rowCount(); ++row) {
      all << model.index(row).data(kTimeRole).toString();
    }
    return all;
  };

  EXPECT_EQ(times(1), (QStringList{ClockText(1), QString(ClockText(1).size(), ' ')}));
  EXPECT_EQ(times(0), (QStringList{QString(), QString()})) << "no time is known";
}

TEST(ProblemsModel, ListsAWaitingComponentUntilConnectedOrStopped) {
  ProblemsModel model;
  SystemBuilder system = LookSystem(0);
  const auto texts = [&] {
    model.update(system.catalogue());
    QStringList all;
    for (int row = 0; row < model.rowCount(); ++row) all << model.row(row).text;
    return all.filter("teleoperation");
  };
  EXPECT_EQ(texts(), QStringList("desk/teleoperation waits for Robot: not connected"));
  EXPECT_EQ(model.row(model.rowCount() - 1).mark, StateMark::kWarning);

  system.Connect(kRobot, kControl, ConnectionState::kPending, "process 'robot' is not available");
  EXPECT_EQ(texts(), QStringList("desk/teleoperation waits for Robot: pending: process 'robot' is "
                                 "not available"));

  system.Connect(kRobot, kControl);
  EXPECT_TRUE(texts().isEmpty());

  system.Disconnect(kRobot);
  ComponentDescription stopped = *system.catalogue().FindComponent("desk", "teleoperation");
  stopped.state = ComponentState::kFinished;
  system.Component("desk", stopped);
  EXPECT_TRUE(texts().isEmpty());
}

TEST(ProblemsModel, ListsAPluginOlderThanItsFile) {
  ProblemsModel model;
  SystemBuilder system = LookSystem(0);
  ProcessDescription robot = system.catalogue().FindProcess("robot")->process;
  const auto texts = [&](PluginState state) {
    robot.plugins = {
        {.name = "arm", .file = "/opt/arm.so", .written = 1, .state = state, .written_now = 2}};
    system.Process(robot);
    model.update(system.catalogue());
    QStringList all;
    for (int row = 0; row < model.rowCount(); ++row) all << model.row(row).text;
    return all.filter("arm.so");
  };

  EXPECT_TRUE(texts(PluginState::kCurrent).isEmpty());
  EXPECT_TRUE(texts(PluginState::kChanged).value(0).startsWith("robot runs arm.so of "));
  EXPECT_TRUE(texts(PluginState::kChanged).value(0).contains("; the file was written again at "));
  EXPECT_TRUE(texts(PluginState::kGone).value(0).contains("; the file is missing"));
}

TEST(ProblemsModel, ListsAProcessThatOthersCannotReach) {
  const std::string reason = "can be reached at 127.0.0.1:43211 only from its own host";
  ProblemsModel model;
  SystemBuilder system;
  system.Process("robot", ProcessState::kAlive, 0, 1, reason);

  model.update(system.catalogue());

  ASSERT_EQ(model.rowCount(), 1);
  EXPECT_EQ(model.row(0).text, "robot: " + ToQString(reason));
  EXPECT_EQ(model.row(0).path, "robot");
}

TEST(ActivityModel, AReplacementIsOneStep) {
  ActivityModel model;
  Action replacing = Connecting();
  replacing.verb = Action::Verb::kReplace;
  model.finish(model.begin(replacing), 0.1, {});

  EXPECT_TRUE(model.canUndo(0));
  EXPECT_EQ(model.command(0),
            "gcm connect desk/teleoperation/Robot robot/controller/Control --replace");
}

TEST(ProblemsModel, ARefusalStaysUntilTheInterfaceIsConnected) {
  ProblemsModel model;
  SystemBuilder system = LookSystem(0);
  model.update(system.catalogue());
  const int before = model.rowCount();
  QSignalSpy counts(&model, &ProblemsModel::countChanged);
  Action refused = Connecting();
  refused.outcome = Action::Outcome::kRefused;
  refused.refusal = "does not fit";

  model.onActionFinished(refused);
  model.update(system.catalogue());
  EXPECT_EQ(model.rowCount(), before + 1);

  system.Connect(kRobot, kControl);
  model.update(system.catalogue());
  EXPECT_EQ(model.rowCount(), before - 1) << "nor does its component wait any more";
  EXPECT_EQ(counts.count(), 2);
}

}  // namespace
}  // namespace tendon::gui
