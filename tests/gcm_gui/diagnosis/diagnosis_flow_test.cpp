#include <gcm_gui/activity/activity_strip.h>
#include <gcm_gui/diagnosis/diagnosis_card.h>
#include <gcm_gui/graph/items/edge_item.h>
#include <gcm_gui/views/row_view.h>
#include <gcm_gui/views/tab_panel.h>

#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QTabBar>
#include <QTest>
#include <QToolButton>
#include <csignal>

#include "diagnosis/real_system.h"
#include "support/pictures.h"

namespace tendon::gui {
namespace {

const InterfaceName kSlave{"desk", "teleoperation", "Robot"};
const InterfaceName kArm{"robot", "arm", "Control"};
const QString kSlavePath = QStringLiteral("desk/teleoperation/Robot");

class DiagnosisFlowTest : public RealSystem {
 protected:
  [[nodiscard]] DiagnosisCard& card() { return *window().findChild<DiagnosisCard*>(); }
  [[nodiscard]] QString Text(const char* label) {
    const auto* found = card().findChild<QLabel*>(label);
    return found == nullptr || found->isHidden() ? QString() : found->text();
  }
  template <typename Button>
  void Click(const char* name) {
    auto* button = card().findChild<Button*>(name);
    ASSERT_NE(button, nullptr) << name;
    QTest::mouseClick(button, Qt::LeftButton);
  }
  void Connect() {
    ClickPort({Side::kRequired, kSlave});
    ClickPort({Side::kProvided, kArm});
  }
  [[nodiscard]] EdgeItem::Look Look() {
    const EdgeItem* edge = window().graph().graph().edge(kSlavePath);
    return edge == nullptr ? EdgeItem::Look::kPreview : edge->look();
  }
};

TEST_F(DiagnosisFlowTest, ARefusedConnectionStaysRedAndCanBeRetried) {
  StartLcm("robot");
  StartLcm("desk");
  lcm("desk").Signal(SIGSTOP);

  Connect();
  ASSERT_TRUE(Eventually([&] { return Look() == EdgeItem::Look::kFailed; }));
  ASSERT_TRUE(Eventually([&] { return StateOf("desk") == ProcessState::kLost; }));
  ClickEdge(kSlavePath);

  EXPECT_TRUE(card().isVisible());
  ASSERT_TRUE(Eventually([&] { return Text("why.verdict") == "fails at step 1 of 7"; }))
      << Text("why.verdict").toStdString();
  EXPECT_TRUE(Text("why.history").startsWith("refused at ")) << Text("why.history").toStdString();
  EXPECT_TRUE(Text("why.fix").startsWith(
      "fix: the process may be stopped, may hang, or may have lost its connection"))
      << Text("why.fix").toStdString();
  EXPECT_TRUE(Text("why.leftovers").startsWith("left over: "));
  KeepPictures(window(), "why-refused");

  lcm("desk").Signal(SIGCONT);
  ASSERT_TRUE(Eventually([&] { return StateOf("desk") == ProcessState::kAlive; }));
  if (!IsConnected(kSlave)) {
    ASSERT_TRUE(Eventually([&] { return Text("why.verdict") != "fails at step 1 of 7"; }));
    Click<QPushButton>("why.retry");
  }
  EXPECT_TRUE(Eventually([&] { return Look() == EdgeItem::Look::kActive; }));
  EXPECT_TRUE(Eventually([&] { return Text("why.verdict") == "connected and working"; }))
      << Text("why.verdict").toStdString();
  EXPECT_TRUE(Text("why.step7").contains("'robot' answers within"));
  KeepPictures(window(), "why-connected");
}

TEST_F(DiagnosisFlowTest, APickedMismatchStaysRedAndIsExplained) {
  StartLcm("robot");
  StartLcm("desk");

  ClickPort({Side::kRequired, kSlave});
  ClickPort({Side::kProvided, {"desk", "old_arm", "Control"}});

  ASSERT_TRUE(Eventually([&] { return Look() == EdgeItem::Look::kFailed; }));
  QTest::keyClick(&window(), Qt::Key_Escape);
  QTest::keyClick(&window(), Qt::Key_W);
  ASSERT_TRUE(Eventually([&] { return Text("why.verdict") == "fails at step 4 of 7"; }))
      << Text("why.verdict").toStdString();
  EXPECT_EQ(Text("why.title"), "teleoperation/Robot → old_arm/Control");
  KeepPictures(window(), "why-misfit");
  QTest::keyClick(&window(), Qt::Key_Escape);

  Connect();
  EXPECT_TRUE(Eventually([&] { return Look() == EdgeItem::Look::kActive; }));
}

TEST_F(DiagnosisFlowTest, TheReportMatchesTheConsole) {
  StartLcm("robot");
  StartLcm("desk");
  lcm("robot").Signal(SIGSTOP);

  Connect();
  ASSERT_TRUE(Eventually([&] { return Look() == EdgeItem::Look::kPending; }));
  ASSERT_TRUE(Eventually([&] { return StateOf("robot") == ProcessState::kLost; }));
  ClickEdge(kSlavePath);
  ASSERT_TRUE(Eventually([&] { return Text("why.verdict") == "fails at step 1 of 7"; }));
  Click<QPushButton>("why.copyReport");

  QStringList said = QGuiApplication::clipboard()->text().split('\n');
  const Outcome outcome = Gcm({"explain", kSlavePath.toStdString(), "robot/arm/Control"});
  QStringList expected = QString::fromStdString(outcome.out).split('\n', Qt::SkipEmptyParts);
  // The two interfaces, seven steps, a remedy, and the leftovers.
  ASSERT_EQ(expected.size(), 10) << outcome.out;
  for (const QString& line : expected.mid(1)) {
    EXPECT_TRUE(said.contains(line)) << line.toStdString() << "\nis not in\n"
                                     << said.join('\n').toStdString();
  }

  lcm("robot").Signal(SIGCONT);
  EXPECT_TRUE(Eventually([&] { return Text("why.verdict") == "connected and working"; }))
      << Text("why.verdict").toStdString();
}

TEST_F(DiagnosisFlowTest, TheKeyboardOpensTheSignatureComparison) {
  StartLcm("desk");
  window().selection().select(kSlavePath);
  window().graph().setFocus();

  QTest::keyClick(&window(), Qt::Key_W);
  ASSERT_TRUE(Eventually([&] { return Text("why.verdict") == "fails at step 4 of 7"; }))
      << Text("why.verdict").toStdString();
  const auto press_until = [&](const char* name) {
    for (int step = 0; step < 20; ++step) {
      if (window().focusWidget()->objectName() == name) return true;
      QTest::keyClick(window().focusWidget(), Qt::Key_Tab);
    }
    return false;
  };
  ASSERT_TRUE(press_until("why.copyFix"));
  QTest::keyClick(window().focusWidget(), Qt::Key_Return);
  EXPECT_EQ(QGuiApplication::clipboard()->text(), "gcm candidates desk/teleoperation/Robot");
  ASSERT_TRUE(press_until("why.sides"));
  QTest::keyClick(window().focusWidget(), Qt::Key_Space);

  auto* sides = card().findChild<RowView*>("why.signatures");
  ASSERT_TRUE(sides->isVisible());
  const auto verdict_of = [&](const QString& member) {
    const auto found = sides->model()->match(sides->model()->index(0, 0), Qt::DisplayRole, member);
    return found.isEmpty() ? QString() : found.front().siblingAtColumn(2).data().toString();
  };
  EXPECT_EQ(verdict_of("Stop"), "same");
  EXPECT_EQ(verdict_of("MoveTo"), "other type");
  EXPECT_TRUE(verdict_of("GoalReached").startsWith("missing"));
  KeepPictures(window(), "why-signatures");

  QTest::keyClick(window().focusWidget(), Qt::Key_Escape);
  EXPECT_FALSE(card().isVisible());
  EXPECT_EQ(window().focusWidget(), &window().graph());
}

TEST_F(DiagnosisFlowTest, AProblemRowAndTheInspectorOpenTheCard) {
  StartLcm("robot");
  StartLcm("desk");
  lcm("desk").Signal(SIGSTOP);
  Connect();
  ASSERT_TRUE(Eventually([&] { return Look() == EdgeItem::Look::kFailed; }));

  window().strip().showProblems();
  // The row of the refusal contains the message of the GCM.
  ClickRow("problems", window().parts().activity.action(0).refusal);
  EXPECT_TRUE(card().isVisible());
  QTest::keyClick(window().focusWidget(), Qt::Key_Escape);
  EXPECT_FALSE(card().isVisible());

  window().selection().select(kSlavePath);
  auto* why = window().findChild<QToolButton*>("why");
  ASSERT_NE(why, nullptr);
  QTest::mouseClick(why, Qt::LeftButton);
  EXPECT_TRUE(card().isVisible());
  lcm("desk").Signal(SIGCONT);
}

TEST_F(DiagnosisFlowTest, SeveralInterfacesAreMatchedAndConnectedTogether) {
  StartLcm("robot");
  StartLcm("desk");
  window().selection().setPaths({kSlavePath, "desk/supervisor/Robot"});
  // Disconnects the connection that the system file has made.
  QTest::keyClick(&window(), Qt::Key_D);
  const InterfaceName supervisor{"desk", "supervisor", "Robot"};
  ASSERT_TRUE(Eventually([&] { return Known().FindConnection(supervisor) == nullptr; }));
  window().graph().setFocus();

  QTest::keyClick(&window(), Qt::Key_C);
  auto* box = window().findChild<QCheckBox*>("match." + kSlavePath);
  ASSERT_NE(box, nullptr);
  EXPECT_TRUE(box->isChecked());
  KeepPictures(window(), "match");
  QTest::keyClick(window().focusWidget(), Qt::Key_Return);

  EXPECT_TRUE(Eventually([&] { return IsConnected(kSlave) && IsConnected(supervisor); }));
}

}  // namespace
}  // namespace tendon::gui
