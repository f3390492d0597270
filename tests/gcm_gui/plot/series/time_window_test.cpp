#include <gcm_gui/plot/series/time_window.h>
#include <gmock/gmock.h>

#include "../samples.h"

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;

TEST(TimeWindow, ALiveWindowEndsNow) {
  TimeWindow window;
  window.setLength(10s);

  EXPECT_TRUE(window.follow(100 * kSecond, 1000));

  EXPECT_NEAR(static_cast<double>(window.timeAt(window.to())), 100e9, 10e6);
  EXPECT_NEAR(static_cast<double>(window.timeAt(window.from())), 90e9, 10e6);
}

TEST(TimeWindow, MovesByWholeColumns) {
  TimeWindow window;
  window.setLength(10s);
  window.follow(100 * kSecond, 1000);
  const std::int64_t before = window.origin();

  EXPECT_FALSE(window.follow(100 * kSecond - 9 * kMillisecond, 1000)) << "still the same column";
  EXPECT_TRUE(window.follow(100 * kSecond + 25 * kMillisecond, 1000));

  EXPECT_EQ((window.origin() - before) % (10 * kMillisecond), 0);
  EXPECT_GT(window.origin(), before);
}

TEST(TimeWindow, AHeldWindowDoesNotMove) {
  TimeWindow window;
  window.follow(100 * kSecond, 1000);
  window.hold();

  EXPECT_FALSE(window.follow(200 * kSecond, 1000));

  EXPECT_NEAR(static_cast<double>(window.timeAt(0)), 100e9, 30e6);
}

TEST(TimeWindow, ZoomingKeepsThePointUnderTheMouse) {
  TimeWindow window;
  window.zoom(0.5, -10);

  EXPECT_FALSE(window.isLive());
  EXPECT_DOUBLE_EQ(window.from(), -20);
  EXPECT_DOUBLE_EQ(window.to(), -5);
}

TEST(TimeWindow, LimitsTheZoom) {
  TimeWindow window;
  window.zoom(1e-12, -10);
  EXPECT_GT(window.to() - window.from(), 1e-5);
  window.zoom(1e20, -10);
  EXPECT_LT(window.to() - window.from(), 1e6);
}

TEST(TimeWindow, GoingLiveRestoresTheChosenLength) {
  TimeWindow window;
  window.setLength(5s);
  window.show(-3, -2);
  window.setLength(7s);
  EXPECT_DOUBLE_EQ(window.from(), -9);
  EXPECT_DOUBLE_EQ(window.to(), -2) << "the right edge of what is looked at stays";
  EXPECT_FALSE(window.isLive());

  window.goLive();

  EXPECT_TRUE(window.isLive());
  EXPECT_DOUBLE_EQ(window.from(), -7);
  EXPECT_DOUBLE_EQ(window.to(), 0);
}

TEST(SweepingTime, TheAxisIsFixedUntilTheSweepRestarts) {
  TimeWindow window;
  window.setLength(10s);
  window.setMotion(TimeWindow::Motion::kSweep);
  window.follow(23 * kSecond, 1000);
  EXPECT_EQ(window.origin(), 20 * kSecond);
  EXPECT_DOUBLE_EQ(window.head(), 3);

  EXPECT_TRUE(window.follow(29 * kSecond, 1000));
  EXPECT_EQ(window.origin(), 20 * kSecond);
  EXPECT_TRUE(window.follow(31 * kSecond, 1000));

  EXPECT_EQ(window.origin(), 30 * kSecond);
  EXPECT_DOUBLE_EQ(window.head(), 1);
  EXPECT_EQ(window.firstTime(), 21 * kSecond);
  EXPECT_EQ(window.lastTime(), 31 * kSecond);
}

TEST(SweepingTime, RightOfTheHeadIsThePreviousSweep) {
  TimeWindow window;
  window.setLength(10s);
  window.setMotion(TimeWindow::Motion::kSweep);
  window.follow(23 * kSecond, 1000);

  EXPECT_EQ(window.shownAt(2), 22 * kSecond);
  EXPECT_EQ(window.shownAt(7), 17 * kSecond);
  EXPECT_DOUBLE_EQ(window.pointOf(17 * kSecond), 7);
}

TEST(SweepingTime, ZoomingEndsTheSweep) {
  TimeWindow window;
  window.setLength(10s);
  window.setMotion(TimeWindow::Motion::kSweep);
  window.follow(23 * kSecond, 1000);
  TimeWindow across = window;

  window.zoom(0.5, 7);
  EXPECT_FALSE(window.isSweeping());
  EXPECT_EQ(window.firstTime(), 15 * kSecond);
  EXPECT_EQ(window.lastTime(), 20 * kSecond);

  across.show(2, 7);  // across the head: from the previous sweep to the present one
  EXPECT_EQ(across.firstTime(), 17 * kSecond);
  EXPECT_EQ(across.lastTime(), 22 * kSecond);

  across.goLive();
  EXPECT_TRUE(across.isSweeping());
}

TEST(SweepingTime, AHeldWindowIsUnchangedUntilItScrolls) {
  TimeWindow window;
  window.setLength(10s);
  window.setMotion(TimeWindow::Motion::kSweep);
  window.follow(23 * kSecond, 1000);
  window.hold();
  EXPECT_TRUE(window.isSweeping());
  EXPECT_FALSE(window.follow(25 * kSecond, 1000));

  window.setMotion(TimeWindow::Motion::kScroll);

  EXPECT_EQ(window.firstTime(), 13 * kSecond);
  EXPECT_EQ(window.lastTime(), 23 * kSecond);
}

}  // namespace
}  // namespace tendon::gui
