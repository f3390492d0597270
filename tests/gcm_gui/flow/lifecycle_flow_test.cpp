#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/inspector/inspector.h>
#include <gcm_gui/lifecycle/lifecycle_card.h>
#include <gcm_gui/models/selection.h>
#include <gcm_gui/window/notice_line.h>

#include <QLabel>
#include <algorithm>

#include "flow/flow_fixture.h"
#include "support/pictures.h"

namespace tendon::gui {
namespace {

class LifecycleFlowTest : public FlowFixture {
 protected:
  [[nodiscard]] bool IsArm(ComponentState state) const {
    const auto* arm = session_->store().catalogue().FindComponent("robot", "arm");
    return arm != nullptr && arm->state == state;
  }
  [[nodiscard]] const ActivityModel& activity() const { return session_->activity(); }
  /// Presses the key of an order, and confirms with Enter.
  void Order(Qt::Key key) {
    QTest::keyClick(window_.get(), key);
    auto* card = window_->findChild<LifecycleCard*>();
    ASSERT_TRUE(card->isVisible());
    QTest::keyClick(card, Qt::Key_Return);
  }
  /// Returns true if the inspector shows this text.
  [[nodiscard]] bool HasText(const QString& text) const {
    const auto labels = window_->inspector().findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
      return label->isVisible() && label->text().contains(text);
    });
  }
  bool IsOver() {
    return Eventually([&] { return activity().action(0).outcome != Action::Outcome::kRunning; });
  }
};

TEST_F(LifecycleFlowTest, StopsAComponentUndoesTheStopAndSuspendsIt) {
  window_->selection().select(QStringLiteral("robot/arm"));
  Order(Qt::Key_F8);
  ASSERT_TRUE(Eventually([&] { return IsArm(ComponentState::kFinished); }));
  ASSERT_TRUE(IsOver());
  EXPECT_EQ(activity().command(0), "gcm stop robot/arm");
  EXPECT_TRUE(activity().canUndo(0));
  KeepPictures(*window_, "flow-lifecycle-stopped");
  EXPECT_FALSE(HasText(QStringLiteral(" · now "))) << "it has no period now";

  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(Eventually([&] { return activity().rowCount() == 2; }));
  ASSERT_TRUE(IsOver());
  EXPECT_TRUE(activity().action(0).refusal.contains("stop robot/arm"));
  EXPECT_TRUE(IsArm(ComponentState::kFinished));
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(Eventually([&] { return IsArm(ComponentState::kActive); }));
  EXPECT_TRUE(
      Eventually([&] { return activity().rowCount() == 3 && activity().action(2).undone; }));

  Order(Qt::Key_F7);
  EXPECT_TRUE(Eventually([&] { return IsArm(ComponentState::kSuspended); }));
  Order(Qt::Key_F6);
  EXPECT_TRUE(Eventually([&] { return IsArm(ComponentState::kActive); }));
}

}  // namespace
}  // namespace tendon::gui
