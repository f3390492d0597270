#include <gcm_gui/diagnosis/diagnosis_card.h>
#include <gcm_gui/graph/graph_view.h>

#include <QAbstractButton>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

const InterfaceName kTeleoperation{"desk", "teleoperation", "Robot"};

class DiagnosisCardTest : public WindowFixture {
 protected:
  [[nodiscard]] DiagnosisCard& card() { return *window_.findChild<DiagnosisCard*>(); }
  [[nodiscard]] QString Verdict() { return card().findChild<QLabel*>("why.verdict")->text(); }
  void Ask() {
    window_.selection().select("desk/teleoperation/Robot");
    window_.graph().setFocus();
    QTest::keyClick(&window_, Qt::Key_W);
  }
  void Answer() { checks_.diagnosis(Diagnose(store_.catalogue(), checks_.diagnosed.back())); }
};

TEST_F(DiagnosisCardTest, OpensAtOnceAndShowsTheResultLater) {
  Ask();

  EXPECT_TRUE(card().isVisible());
  EXPECT_EQ(Verdict(), "checking …");
  ASSERT_EQ(checks_.diagnosed.size(), 1u);
  EXPECT_EQ(checks_.diagnosed.front().required, kTeleoperation);

  Answer();

  EXPECT_EQ(Verdict(), "nothing prevents the connection");
}

TEST_F(DiagnosisCardTest, RetryConnectsAndTheCardFollowsTheSystem) {
  Ask();
  Answer();
  QTest::mouseClick(card().findChild<QPushButton*>("why.retry"), Qt::LeftButton);
  EXPECT_EQ(actions_.asked,
            QStringList{"connect desk/teleoperation/Robot robot/controller/Control"});

  system_.Process("robot", ProcessState::kLost);
  Show();
  Answer();

  EXPECT_EQ(Verdict(), "fails at step 1 of 7");
}

TEST_F(DiagnosisCardTest, IgnoresAnAnswerForAnotherConnection) {
  Ask();
  const auto late = checks_.diagnosis;
  QTest::keyClick(window_.focusWidget(), Qt::Key_Escape);
  EXPECT_FALSE(card().isVisible());

  late(Diagnose(store_.catalogue(), checks_.diagnosed.back()));

  EXPECT_FALSE(card().isVisible());
}

TEST_F(DiagnosisCardTest, EveryButtonHasAName) {
  Ask();
  Answer();

  for (const auto* button : card().findChildren<QAbstractButton*>()) {
    EXPECT_FALSE(button->accessibleName().isEmpty()) << button->objectName().toStdString();
    EXPECT_TRUE((button->focusPolicy() & Qt::TabFocus) != 0) << button->objectName().toStdString();
  }
}

}  // namespace
}  // namespace tendon::gui
