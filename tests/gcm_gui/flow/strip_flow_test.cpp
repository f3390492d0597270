#include <gcm_gui/activity/activity_strip.h>
#include <gcm_gui/console/console_page.h>
#include <gcm_gui/models/row_roles.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>

#include "flow/flow_fixture.h"
#include "support/pictures.h"

namespace tendon::gui {
namespace {

class StripFlow : public FlowFixture {
 protected:
  ConsolePage& Console() { return window_->strip().console(); }
  QLineEdit& Line() { return Find<QLineEdit>("console.line"); }
  void Type(const QString& line) {
    QTest::keyClicks(&Line(), line);
    QTest::keyClick(&Line(), Qt::Key_Return);
  }
  bool Says(const QString& text) {
    return Eventually([&] { return Console().text().contains(text); });
  }
  bool IsDone() {
    return Eventually([&] { return !Console().isRunning(); });
  }
};

TEST_F(StripFlow, TheConsoleRunsShellCommands) {
  QTest::keyClick(window_.get(), Qt::Key_J, Qt::ControlModifier);
  ASSERT_TRUE(Line().hasFocus());

  Type("ls robot");
  EXPECT_TRUE(Says("arm"));
  ASSERT_TRUE(IsDone());
  Type("cd robot/arm");
  EXPECT_TRUE(Eventually([&] { return Find<QLabel>("console.prompt").text() == "robot/arm>"; }));

  Type("watch state.Joints --hz 20");
  EXPECT_TRUE(Says("position"));
  EXPECT_TRUE(Console().isRunning());
  QTest::keyClick(&Line(), Qt::Key_C, Qt::ControlModifier);
  ASSERT_TRUE(IsDone());
  EXPECT_TRUE(Says(" lost"));

  QTest::keyClick(&Line(), Qt::Key_Up);
  EXPECT_EQ(Line().text(), "watch state.Joints --hz 20");
  QTest::keyClick(&Line(), Qt::Key_C, Qt::ControlModifier);
  EXPECT_EQ(Line().text(), "");
  QTest::keyClick(&Line(), Qt::Key_R, Qt::ControlModifier);
  QTest::keyClicks(&Line(), "ls");
  EXPECT_EQ(Line().text(), "ls robot");
  QTest::keyClick(&Line(), Qt::Key_Escape);
  EXPECT_EQ(Line().text(), "");

  QTest::keyClicks(&Line(), "show /desk/super");
  QTest::keyClick(&Line(), Qt::Key_Tab);
  EXPECT_TRUE(Eventually([&] { return Line().text().startsWith("show /desk/supervisor"); }))
      << Line().text().toStdString();
  KeepPictures(*window_, "flow-console");
}

TEST_F(StripFlow, TheConsoleExplainsVerbsThatNeedATerminal) {
  ClickTab("strip.tabs", "Console");
  ASSERT_TRUE(Line().hasFocus());

  Type("shell");
  EXPECT_TRUE(Says("this is already gcm shell"));
  ASSERT_TRUE(IsDone());
  Type("serve");
  EXPECT_TRUE(Says("start gcm serve in a terminal"));
  ASSERT_TRUE(IsDone());
  Type("run -");
  EXPECT_TRUE(Says("this console has no standard input"));
  ASSERT_TRUE(IsDone());
  Type("top");
  EXPECT_TRUE(Says("TASK"));
  ASSERT_TRUE(IsDone());
  Type("exit");
  ASSERT_TRUE(IsDone());
  Type("ls");
  EXPECT_TRUE(Says("desk"));
  EXPECT_TRUE(IsDone());
}

TEST_F(StripFlow, TheLogIsFilteredAndItsLevelSetWithMouseAndKeys) {
  ClickTab("strip.tabs", "Log");
  auto& list = Find<QTreeView>("log");
  ASSERT_TRUE(Eventually([&] { return list.model()->rowCount() > 0; }));

  auto& words = Find<QLineEdit>("log.filter");
  Click(words);
  QTest::keyClicks(&words, "from:robot");
  EXPECT_TRUE(Eventually([&] { return list.model()->rowCount() > 0; }));
  for (int row = 0; row < list.model()->rowCount(); ++row) {
    EXPECT_TRUE(list.model()->index(row, 0).data(kPathRole).toString().startsWith("robot"));
  }
  KeepPictures(*window_, "flow-log");

  bool was_open = false;
  QTimer::singleShot(0, window_.get(), [&] {
    ASSERT_TRUE(Eventually([] { return QApplication::activePopupWidget() != nullptr; }));
    QWidget* menu = QApplication::activePopupWidget();
    QTest::keyClick(menu, Qt::Key_Down);
    QTest::keyClick(menu, Qt::Key_Right);
    ASSERT_TRUE(Eventually([&] { return QApplication::activePopupWidget() != menu; }));
    QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Return);
    was_open = true;
  });
  Click(Find<QToolButton>("log.setLevel"));
  ASSERT_TRUE(was_open);
  EXPECT_TRUE(Eventually([&] {
    return session_->activity().rowCount() > 0 &&
           session_->activity().action(0).outcome == Action::Outcome::kDone;
  }));
  EXPECT_EQ(session_->activity().command(0), "gcm log-level desk debug");
}

TEST_F(StripFlow, TypingOnTheOutputGoesToTheLine) {
  QTest::keyClick(window_.get(), Qt::Key_J, Qt::ControlModifier);
  ASSERT_TRUE(Line().hasFocus());
  window_->selection().select("desk/supervisor/Robot");
  auto& output = Find<QPlainTextEdit>("console.output");
  output.setFocus();

  QTest::keyClick(&output, Qt::Key_D);

  EXPECT_EQ(Line().text(), "d");
  EXPECT_EQ(session_->activity().rowCount(), 0);
}

TEST_F(StripFlow, EventsArriveLiveAndWaitWhilePaused) {
  ClickTab("strip.tabs", "Events");
  auto& list = Find<QTreeView>("events");
  // The subscription to the events may take a moment. Repeats the move until an event arrives.
  ASSERT_TRUE(Eventually([&] {
    MoveArm();
    return list.model()->rowCount() > 0;
  }));
  EXPECT_TRUE(list.model()->index(0, 0).data(kPathRole).toString().startsWith("robot/arm/"));
  KeepPictures(*window_, "flow-events");

  Click(Find<QToolButton>("events.pause"));
  const int shown = list.model()->rowCount();
  const auto& note = Find<QLabel>("events.rate");
  ASSERT_TRUE(Eventually([&] {
    MoveArm();
    return note.text().contains("waiting") && !note.text().contains(" 0 waiting");
  }));
  EXPECT_EQ(list.model()->rowCount(), shown);
  Click(Find<QToolButton>("events.pause"));
  EXPECT_GT(list.model()->rowCount(), shown);
}

TEST_F(StripFlow, ClickingAProblemSelectsItsSource) {
  robot_.reset();  // kills the process
  ClickTab("strip.tabs", "Problems");
  auto& list = Find<QTreeView>("problems");
  ASSERT_TRUE(Eventually([&] {
    return list.model()->rowCount() > 0 &&
           list.model()->index(0, 0).data(kPathRole).toString() == "robot";
  }));

  QTest::mouseClick(list.viewport(), Qt::LeftButton, {},
                    list.visualRect(list.model()->index(0, 0)).center());

  EXPECT_EQ(window_->selection().current(), "robot");
  KeepPictures(*window_, "flow-problems");
}

}  // namespace
}  // namespace tendon::gui
