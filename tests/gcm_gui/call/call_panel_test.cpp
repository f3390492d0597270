#include <gcm_gui/call/call_panel.h>
#include <gtest/gtest.h>
#include <tendon/gcm/initial_arguments.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include "support/fakes.h"

namespace tendon::gui {
namespace {

const QString kMove = QStringLiteral("robot/arm/Control.Move");
const QString kStop = QStringLiteral("robot/arm/Control.Stop");
const QString kGet = QStringLiteral("robot/arm/Control.Get");

MemberDescription CommandOf(const std::string& name, CommandKind kind) {
  MemberDescription command;
  command.name = name;
  command.signature.kind = kind;
  return command;
}

class CallPanelTest : public ::testing::Test {
 protected:
  CallPanelTest() {
    calls_.schema = Schema::Structure(
        "arm.Move",
        {{.name = "to",
          .unit = "rad",
          .schema = Schema(Schema::Kind::kFloat64),
          .range = {{-1, 1}}},
         {.name = "mode", .unit = {}, .schema = Schema::Enum("arm.Mode", {{"a", 0}, {"b", 1}})}});
    panel_.resize(312, 400);
  }

  void ShowMove() {
    panel_.showCommand(kMove, CommandOf("Move", CommandKind::kWrite));
    panel_.show();
  }
  void ShowStop() {
    panel_.showCommand(kStop, CommandOf("Stop", CommandKind::kVoid));
    panel_.show();
  }
  /// Activates the window, because only an active window receives keys.
  void Activate() {
    panel_.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&panel_, 120'000));
  }
  void Enter(const QString& field, const QString& text) {
    panel_.findChild<QLineEdit*>(QStringLiteral("form.") + field)->setText(text);
  }
  QPushButton& Button() { return *panel_.findChild<QPushButton*>(QStringLiteral("call.call")); }
  QString Status() { return panel_.findChild<QLabel*>(QStringLiteral("call.status"))->text(); }
  QLabel& ResultLabel() { return *panel_.findChild<QLabel*>(QStringLiteral("call.result")); }
  QToolButton& Link(const QString& name) { return *panel_.findChild<QToolButton*>(name); }
  void Click() { QTest::mouseClick(&Button(), Qt::LeftButton); }

  ScriptedCalls calls_;
  CallPanel panel_{calls_};
};

TEST_F(CallPanelTest, CallsWithTheEnteredValues) {
  ShowMove();
  Enter("to", "0.5");

  Click();
  Click();

  EXPECT_EQ(calls_.calls, QStringList{kMove + R"( {"to":0.5,"mode":"a"})"}) << "one at a time";
  EXPECT_EQ(Status(), "Calling…");
}

TEST_F(CallPanelTest, StartsWithTheValueOfTheMatchingReadCommand) {
  panel_.showCommand(kMove, CommandOf("Move", CommandKind::kWrite), {{.name = "Get"}});
  panel_.show();
  ASSERT_EQ(calls_.read, QStringList{kGet});

  calls_.value(std::string(R"({"to":0.25,"mode":"b"})"));

  EXPECT_EQ(Status(), "Current values from Get");
  EXPECT_TRUE(calls_.calls.isEmpty());
  Click();
  EXPECT_EQ(calls_.calls, QStringList{kMove + R"( {"to":0.25,"mode":"b"})"});
}

TEST_F(CallPanelTest, ALateReadDoesNotOverwriteInput) {
  panel_.showCommand(kMove, CommandOf("Move", CommandKind::kWrite), {{.name = "Get"}});
  panel_.show();
  Enter("to", "0.5");

  calls_.value(std::string(R"({"to":0.25,"mode":"b"})"));

  Click();
  EXPECT_EQ(calls_.calls, QStringList{kMove + R"( {"to":0.5,"mode":"a"})"});
}

TEST_F(CallPanelTest, ALateReadDoesNotChangeTheFormWhilePressing) {
  panel_.setCareful(true);
  panel_.showCommand(kMove, CommandOf("Move", CommandKind::kWrite), {{.name = "Get"}});
  panel_.show();
  const auto* field = panel_.findChild<QLineEdit*>("form.to");
  const QString before = field->text();

  QTest::mousePress(&Button(), Qt::LeftButton);
  calls_.value(std::string(R"({"to":0.25,"mode":"b"})"));

  EXPECT_EQ(field->text(), before);
  QTest::mouseRelease(&Button(), Qt::LeftButton);
}

TEST_F(CallPanelTest, ShowsTheReplyOneFieldPerLine) {
  panel_.showCommand(kGet, CommandOf("Get", CommandKind::kRead));
  panel_.show();
  Click();

  calls_.answer(std::string(R"({"position":[1,-0.7853981633974483],"valid":true})"), 0.003);

  EXPECT_EQ(Status(), "Done in 3.000 ms");
  EXPECT_TRUE(ResultLabel().isVisible());
  EXPECT_EQ(ResultLabel().text(), "position: [1, -0.785398]\nvalid: true");
  Click();
  EXPECT_EQ(calls_.calls.size(), 2);
}

TEST_F(CallPanelTest, ShowsTheTextOfARefusal) {
  ShowStop();
  Click();

  calls_.answer(Error{ErrorCode::kTimeout, "no reply in 1 s; it may still be executed"}, 1);

  EXPECT_EQ(Status(), "no reply in 1 s; it may still be executed");
  EXPECT_FALSE(ResultLabel().isVisible());
}

TEST_F(CallPanelTest, ReportsInvalidInputBeforeTheCall) {
  ShowMove();

  Enter("to", "1.5");

  EXPECT_FALSE(Button().isEnabled());
  EXPECT_EQ(Status(), "To be corrected: to");
  EXPECT_EQ(panel_.findChild<QLabel*>("refusals.to")->text(), "write a number from -1 to 1 rad");
  Enter("to", "1");
  EXPECT_TRUE(Button().isEnabled());
  EXPECT_EQ(Status(), "");
}

TEST_F(CallPanelTest, JsonAndFormShowTheSameValue) {
  ShowMove();
  Enter("to", "0.25");

  Link("call.asJson").click();
  auto& json = *panel_.findChild<QPlainTextEdit*>(QStringLiteral("call.json"));
  EXPECT_EQ(json.toPlainText(), "{\n  \"to\": 0.25,\n  \"mode\": \"a\"\n}");
  json.setPlainText("{\"to\": 0.75, \"mode\": \"b\"");
  EXPECT_FALSE(Button().isEnabled());
  json.setPlainText("{\"to\": 0.75, \"mode\": \"b\"}");
  Link("call.asJson").click();
  Click();

  EXPECT_EQ(calls_.calls, QStringList{kMove + R"( {"to":0.75,"mode":"b"})"});
}

TEST_F(CallPanelTest, InvalidJsonCannotBeLeftForTheForm) {
  ShowMove();
  Link("call.asJson").click();
  auto& json = *panel_.findChild<QPlainTextEdit*>(QStringLiteral("call.json"));
  for (const char* wrong :
       {R"({"to": 0,75, "mode": "b"})", R"({"to": 0.5, "to": 0.7, "mode": "b"})"}) {
    json.setPlainText(wrong);

    Link("call.asJson").click();

    EXPECT_TRUE(Link("call.asJson").isChecked());
    EXPECT_TRUE(json.isVisible());
    EXPECT_FALSE(Button().isEnabled());
  }
}

TEST_F(CallPanelTest, RestoresTheLastArgument) {
  ShowMove();
  Enter("to", "-0.5");
  Click();
  ShowStop();

  ShowMove();

  EXPECT_EQ(panel_.findChild<QLineEdit*>(QStringLiteral("form.to"))->text(), "-0.5");
}

TEST_F(CallPanelTest, IgnoresALateReplyOfAnotherCommand) {
  ShowMove();
  Click();
  const auto late = calls_.answer;
  ShowStop();

  late(std::string("1"), 0.5);

  EXPECT_EQ(Status(), "");
  EXPECT_TRUE(Button().isEnabled());
}

TEST_F(CallPanelTest, CannotCallWithoutTheTypeAndCanRetry) {
  const Result<Schema> known = calls_.schema;
  calls_.schema = Error{ErrorCode::kTimeout, "no reply from robot in 2 s"};
  ShowMove();
  EXPECT_FALSE(Button().isEnabled());
  EXPECT_EQ(Status(), "no reply from robot in 2 s");

  calls_.schema = known;
  Link("call.retry").click();

  EXPECT_TRUE(Button().isEnabled());
  EXPECT_FALSE(Link("call.retry").isVisible());
  EXPECT_EQ(Status(), "");
}

TEST_F(CallPanelTest, CopiesTheCallAsACommandLine) {
  ShowMove();
  Enter("to", "0.5");

  Link("call.copy").click();

  EXPECT_EQ(QGuiApplication::clipboard()->text(),
            R"(gcm call robot/arm/Control.Move '{"to":0.5,"mode":"a"}')");
}

TEST_F(CallPanelTest, TheShortcutCallsFromAnyField) {
  ShowMove();
  auto* field = panel_.findChild<QLineEdit*>(QStringLiteral("form.to"));
  Activate();
  panel_.focusFirst();
  EXPECT_TRUE(field->hasFocus());

  QTest::keyClick(field, Qt::Key_Return, Qt::ControlModifier);

  EXPECT_EQ(calls_.calls.size(), 1);
}

TEST_F(CallPanelTest, OneClickDoesNotCallAMotionCommand) {
  ShowStop();
  panel_.setCareful(true);

  Click();

  EXPECT_EQ(calls_.calls.size(), 0);
  EXPECT_TRUE(Status().contains("hold the button")) << Status().toStdString();
}

TEST_F(CallPanelTest, HoldingTheButtonCallsAMotionCommand) {
  ShowStop();
  panel_.setCareful(true);

  QTest::mousePress(&Button(), Qt::LeftButton);
  EXPECT_EQ(calls_.calls.size(), 0);
  EXPECT_TRUE(QTest::qWaitFor([&] { return calls_.calls.size() == 1; }, 120'000));
  QTest::mouseRelease(&Button(), Qt::LeftButton);

  EXPECT_EQ(calls_.calls.size(), 1);
}

TEST_F(CallPanelTest, AHeldButtonCallsOnce) {
  ShowStop();
  panel_.setCareful(true);
  QTest::mousePress(&Button(), Qt::LeftButton);
  ASSERT_TRUE(QTest::qWaitFor([&] { return calls_.calls.size() == 1; }, 120'000));
  calls_.answer(std::string(), 0.001);

  Q_EMIT Button().pressed();  // the pointer has left the button and returned
  QTest::mouseRelease(&Button(), Qt::LeftButton);

  EXPECT_EQ(calls_.calls.size(), 1);
  EXPECT_EQ(Status(), "Done in 1.000 ms") << "no second hold had begun";
}

TEST_F(CallPanelTest, ReleasingOutsideTheButtonCallsNothing) {
  ShowStop();

  QTest::mousePress(&Button(), Qt::LeftButton);
  QTest::mouseRelease(&Button(), Qt::LeftButton, {}, QPoint(-20, -20));

  EXPECT_EQ(calls_.calls.size(), 0);
}

TEST_F(CallPanelTest, ChangingTheCommandResetsTheFirstKeyPress) {
  ShowStop();
  Activate();
  panel_.setCareful(true);
  QTest::keyClick(&Button(), Qt::Key_Return, Qt::ControlModifier);

  panel_.showCommand(kGet, CommandOf("Get", CommandKind::kRead));
  QTest::keyClick(&Button(), Qt::Key_Return, Qt::ControlModifier);

  EXPECT_EQ(calls_.calls.size(), 0);
}

TEST_F(CallPanelTest, PressingTheShortcutTwiceCallsAMotionCommand) {
  ShowStop();
  Activate();
  panel_.setCareful(true);

  QTest::keyClick(&Button(), Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(calls_.calls.size(), 0);
  QTest::keyClick(&Button(), Qt::Key_Return, Qt::ControlModifier);

  EXPECT_EQ(calls_.calls.size(), 1);
}

TEST_F(CallPanelTest, CannotCallAnUnavailableProcess) {
  ShowStop();

  panel_.setUnavailable("robot does not answer");

  EXPECT_FALSE(Button().isEnabled());
  EXPECT_EQ(Status(), "robot does not answer");
  panel_.setUnavailable({});
  EXPECT_TRUE(Button().isEnabled());
}

TEST_F(CallPanelTest, CanBeDestroyedDuringACall) {
  auto panel = std::make_unique<CallPanel>(calls_);
  panel->showCommand(kStop, CommandOf("Stop", CommandKind::kVoid));
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("call.call")), Qt::LeftButton);
  ASSERT_TRUE(calls_.answer);

  panel.reset();

  calls_.answer(std::string(), 0);  // the panel no longer exists
}

TEST_F(CallPanelTest, ShowsWhenACommandExpires) {
  MemberDescription command = CommandOf("MoveAt", CommandKind::kWrite);
  command.expires_after = 0.1;
  panel_.showCommand(QStringLiteral("robot/arm/Control.MoveAt"), command);
  panel_.show();
  const auto* expiry = panel_.findChild<QLabel*>("call.expiry");
  EXPECT_TRUE(expiry->isVisible());
  EXPECT_EQ(expiry->text(), "The action ends unless the command is called again within 100 ms");

  ShowStop();

  EXPECT_FALSE(expiry->isVisible());
}

}  // namespace
}  // namespace tendon::gui
