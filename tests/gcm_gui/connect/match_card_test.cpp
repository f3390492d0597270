#include <gcm_gui/connect/match_card.h>
#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "support/fakes.h"
#include "support/sample_system.h"

namespace tendon::gui {
namespace {

const InterfaceName kTeleoperation{"desk", "teleoperation", "Robot"};
const InterfaceName kView{"desk", "view", "Host"};

class MatchCardTest : public ::testing::Test {
 protected:
  MatchCardTest() {
    window_.resize(900, 600);
    store_.apply(system_.TakeChanges());
    window_.show();
  }
  QCheckBox* Box(const InterfaceName& name) {
    return window_.findChild<QCheckBox*>("match." + QString::fromStdString(ToString(name)));
  }
  QPushButton& Connect() { return *window_.findChild<QPushButton*>("match.connect"); }

  SystemBuilder system_ = LookSystem(0);
  CatalogueStore store_;
  RecordingActions actions_;
  QWidget window_;
  MatchCard card_{window_, store_, actions_};
};

TEST_F(MatchCardTest, ChecksUnambiguousPairsAndConnectsThemTogether) {
  system_.Disconnect(kView);
  store_.apply(system_.TakeChanges());
  card_.open({kTeleoperation, kView});
  ASSERT_TRUE(Box(kTeleoperation)->isChecked());
  ASSERT_TRUE(Box(kView)->isChecked());
  EXPECT_EQ(Connect().text(), "Connect 2");

  QTest::mouseClick(&Connect(), Qt::LeftButton);

  EXPECT_EQ(actions_.asked,
            (QStringList{"connect if free desk/teleoperation/Robot robot/controller/Control",
                         "connect if free desk/view/Host desk/host_monitor/state"}));
  EXPECT_FALSE(card_.isVisible());
}

TEST_F(MatchCardTest, UncheckedPairsAreNotConnected) {
  card_.open({kTeleoperation});
  QTest::keyClick(Box(kTeleoperation), Qt::Key_Space);
  EXPECT_FALSE(Connect().isEnabled());

  QTest::keyClick(Box(kTeleoperation), Qt::Key_Return);

  EXPECT_TRUE(actions_.asked.isEmpty());
  EXPECT_TRUE(card_.isVisible());
}

TEST_F(MatchCardTest, ConnectedPairsCannotBeChecked) {
  system_.Connect(kView, {"desk", "host_monitor", "state"});
  store_.apply(system_.TakeChanges());

  card_.open({kTeleoperation, kView});

  EXPECT_FALSE(Box(kView)->isEnabled());
  EXPECT_EQ(Connect().text(), "Connect 1");
}

TEST_F(MatchCardTest, AmbiguousPairsAreNotChecked) {
  ComponentDescription twin = *system_.catalogue().FindComponent("robot", "controller");
  twin.name = "twin";
  system_.Component("robot", twin);
  store_.apply(system_.TakeChanges());

  card_.open({kTeleoperation});

  ASSERT_TRUE(Box(kTeleoperation)->isEnabled());
  EXPECT_FALSE(Box(kTeleoperation)->isChecked());
  EXPECT_TRUE(Box(kTeleoperation)->accessibleName().endsWith("one of 2"));
}

}  // namespace
}  // namespace tendon::gui
