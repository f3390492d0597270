#include <gcm_gui/call/repeat_row.h>
#include <gcm_gui/call/repeater.h>
#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "support/fakes.h"

namespace tendon::gui {
namespace {

constexpr int kRepeatTimeout = 120'000;  // ms

class RepeaterTest : public ::testing::Test {
 protected:
  ScriptedCalls calls_;
  Repeater repeater_{calls_};
  QSignalSpy stopped_{&repeater_, &Repeater::stopped};
};

TEST_F(RepeaterTest, RunsOneCallAtATime) {
  repeater_.start("a/b/C.Set", "1", 100, 0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return repeater_.leftOut() >= 3; }, kRepeatTimeout));
  EXPECT_EQ(calls_.calls, QStringList{"a/b/C.Set 1"});

  calls_.answer(std::string(), 0.001);

  EXPECT_TRUE(QTest::qWaitFor([&] { return calls_.calls.size() == 2; }, kRepeatTimeout));
}

TEST_F(RepeaterTest, ARestartWaitsForThePreviousCall) {
  repeater_.start("a/b/C.Set", "1", 100, 0);
  repeater_.stop();
  repeater_.start("a/b/C.Set", "2", 100, 0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return repeater_.leftOut() >= 3; }, kRepeatTimeout));
  EXPECT_EQ(calls_.calls, QStringList{"a/b/C.Set 1"});

  calls_.answer(std::string(), 0.001);

  ASSERT_TRUE(QTest::qWaitFor([&] { return calls_.calls.size() == 2; }, kRepeatTimeout));
  EXPECT_EQ(calls_.calls.at(1), "a/b/C.Set 2");
}

TEST(RepeatRowTest, AClickDoesNotRepeatAMotionCommand) {
  ScriptedCalls calls;
  RepeatRow row(calls, [] { return std::string("1"); });
  row.setCommand("a/b/C.Move");
  row.setCareful(true);
  row.show();
  auto* button = row.findChild<QPushButton*>("call.repeat");

  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_TRUE(calls.calls.isEmpty());
  QTest::mousePress(button, Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !calls.calls.isEmpty(); }, kRepeatTimeout));
  QTest::mouseRelease(button, Qt::LeftButton);

  EXPECT_FALSE(row.repeater().isRunning());
}

TEST_F(RepeaterTest, EndsAfterTheGivenNumberOfCalls) {
  repeater_.start("a/b/C.Set", "", 100, 2);
  calls_.answer(std::string(), 0.001);
  ASSERT_TRUE(QTest::qWaitFor([&] { return calls_.calls.size() == 2; }, kRepeatTimeout));
  EXPECT_TRUE(repeater_.isRunning());

  calls_.answer(std::string(), 0.001);

  EXPECT_FALSE(repeater_.isRunning());
  EXPECT_EQ(stopped_.size(), 1);
}

TEST_F(RepeaterTest, EndsOnARefusal) {
  repeater_.start("a/b/C.Set", "", 100, 0);
  calls_.answer(Error{ErrorCode::kFailed, "not now"}, 0.001);

  EXPECT_FALSE(repeater_.isRunning());
  EXPECT_EQ(stopped_.at(0).at(0).toString(), "not now");
}

TEST_F(RepeaterTest, IgnoresAReplyAfterTheEnd) {
  repeater_.start("a/b/C.Set", "", 100, 0);
  repeater_.stop();
  calls_.answer(Error{ErrorCode::kFailed, "too late"}, 0.001);

  EXPECT_EQ(stopped_.size(), 1);
  EXPECT_EQ(stopped_.at(0).at(0).toString(), "");
}

TEST(RepeatRowTest, SuggestsARateThatRenewsAnExpiringCommand) {
  ScriptedCalls calls;
  RepeatRow row(calls, [] { return std::string("1"); });
  const auto* rate = row.findChild<QDoubleSpinBox*>("call.rate");

  row.setCommand("a/b/C.MoveAt", 0.1);
  EXPECT_EQ(rate->value(), 20);
  row.setCommand("a/b/C.Move");

  EXPECT_EQ(rate->value(), 1) << "what is called so often may not be wanted of another one";
}

}  // namespace
}  // namespace tendon::gui
