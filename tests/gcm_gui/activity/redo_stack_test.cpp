#include <gcm_gui/activity/redo_stack.h>
#include <gtest/gtest.h>

#include <QSignalSpy>

#include "support/fakes.h"

namespace tendon::gui {
namespace {

const InterfaceName kRedoRobot{"desk", "teleoperation", "Robot"};
const InterfaceName kRedoControl{"robot", "controller", "Control"};

/// A session in which every action of the window succeeds at once.
class RedoStackTest : public ::testing::Test {
 protected:
  static Action Connecting() {
    Action action;
    action.required = kRedoRobot;
    action.provided = kRedoControl;
    return action;
  }
  static Action Disconnecting() {
    Action action;
    action.verb = Action::Verb::kDisconnect;
    action.required = kRedoRobot;
    return action;
  }
  void Do(const Action& action) { activity_.finish(activity_.begin(action), 0.1, {}); }
  void Undo(const Action& step) {
    Action undo;
    undo.verb = Action::Verb::kUndo;
    const auto id = activity_.begin(undo);
    activity_.finish(id, 0.1, {});
    activity_.markUndone(id, step);
  }
  [[nodiscard]] QStringList Asked() { return std::exchange(actions_.asked, {}); }

  ActivityModel activity_;
  RecordingActions actions_;
  RedoStack redo_{activity_, actions_};
};

TEST_F(RedoStackTest, RedoesTheLastUndoFirst) {
  Do(Connecting());
  Do(Disconnecting());
  Undo(Disconnecting());
  Undo(Connecting());

  redo_.again();
  EXPECT_EQ(Asked(),
            QStringList("connect if free desk/teleoperation/Robot robot/controller/Control"));
  redo_.again();
  EXPECT_TRUE(Asked().isEmpty()) << "it is not done yet";
  Do(Connecting());

  redo_.again();
  EXPECT_EQ(Asked(), QStringList("disconnect desk/teleoperation/Robot"));
}

TEST_F(RedoStackTest, ANewActionClearsTheStack) {
  QSignalSpy notice(&redo_, &RedoStack::notice);
  Do(Connecting());
  Undo(Connecting());
  Do(Disconnecting());

  redo_.again();

  EXPECT_TRUE(Asked().isEmpty());
  EXPECT_EQ(notice.count(), 1);
}

TEST_F(RedoStackTest, DoesNotRedoAStop) {
  QSignalSpy notice(&redo_, &RedoStack::notice);
  Action stop;
  stop.verb = Action::Verb::kLifecycle;
  stop.lifecycle_verb = LifecycleVerb::kStop;
  stop.component = "robot/arm";
  Do(stop);
  Undo(stop);

  redo_.again();

  EXPECT_TRUE(Asked().isEmpty());
  EXPECT_EQ(notice.count(), 1);
}

}  // namespace
}  // namespace tendon::gui
