#include <gcm_gui/session/link_state.h>
#include <gcm_gui/window/gcm_switcher.h>
#include <gtest/gtest.h>

#include <QInputDialog>
#include <QSignalSpy>
#include <QTest>
#include <optional>

namespace tendon::gui {
namespace {

TEST(ArgumentsFor, KeepsAllArgumentsExceptTheAddress) {
  EXPECT_EQ(ArgumentsFor({"--gcm", "a:1", "--theme", "dark"}, "b"),
            (QStringList{"--theme", "dark", "--gcm", "b"}));
  EXPECT_EQ(ArgumentsFor({"--listen=a:1", "--read-only"}, "b"),
            (QStringList{"--read-only", "--gcm", "b"}));
  EXPECT_EQ(ArgumentsFor({}, "b"), (QStringList{"--gcm", "b"}));
}

TEST(ArgumentsFor, OmitsTheSystemFileAndDescribeUi) {
  EXPECT_EQ(ArgumentsFor({"lab.json", "--describe-ui", "ui.txt", "--layout", "plots.json"}, "b"),
            (QStringList{"--layout", "plots.json", "--gcm", "b"}));
  EXPECT_EQ(ArgumentsFor({"--insecure", "--no-tour", "lab.json", "--describe-ui=ui.txt"}, "b"),
            (QStringList{"--insecure", "--no-tour", "--gcm", "b"}));
  EXPECT_EQ(ArgumentsFor({"--theme=dark", "--", "lab.json"}, "b"),
            (QStringList{"--theme=dark", "--gcm", "b"}));
}

class GcmSwitcherTest : public ::testing::Test {
 protected:
  GcmSwitcherTest() { window_.show(); }

  void Choose(const QString& address) {
    other_.ask();
    auto* dialog = window_.findChild<QInputDialog*>("otherGcm");
    ASSERT_NE(dialog, nullptr);
    dialog->setTextValue(address);
    QTest::keyClick(dialog, Qt::Key_Return);
  }

  QWidget window_;
  LinkState link_;
  bool starts_ = true;
  std::optional<QStringList> launched_;
  GcmSwitcher& other_ = *new GcmSwitcher(window_, link_, [this](const QStringList& arguments) {
    launched_ = arguments;
    return starts_;
  });
};

TEST_F(GcmSwitcherTest, AnotherWindowReplacesThisOne) {
  Choose(" robot1 ");

  ASSERT_TRUE(launched_);
  EXPECT_EQ(launched_->mid(launched_->size() - 2), (QStringList{"--gcm", "robot1"}));
  EXPECT_FALSE(window_.isVisible());
}

TEST_F(GcmSwitcherTest, AWindowThatHostsTheGcmStaysWithANotice) {
  QSignalSpy notice(&other_, &GcmSwitcher::notice);
  link_.setAddress("127.0.0.1:10705", true);
  Choose("robot1");

  EXPECT_TRUE(launched_);
  EXPECT_TRUE(window_.isVisible());
  ASSERT_EQ(notice.count(), 1);
  EXPECT_TRUE(notice[0][0].toString().startsWith("robot1 is shown in another window"));
}

TEST_F(GcmSwitcherTest, StaysWithANoticeIfTheNewWindowFails) {
  QSignalSpy notice(&other_, &GcmSwitcher::notice);
  starts_ = false;
  Choose("robot1");

  EXPECT_EQ(notice.count(), 1);
  EXPECT_TRUE(window_.isVisible());
}

TEST_F(GcmSwitcherTest, IgnoresAnEmptyAddress) {
  Choose("  ");

  EXPECT_FALSE(launched_);
  EXPECT_TRUE(window_.isVisible());
}

}  // namespace
}  // namespace tendon::gui
