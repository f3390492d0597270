#include <gcm_gui/plot/series/time_window.h>
#include <gmock/gmock.h>

#include "../samples.h"

namespace tendon::gui {
namespace {

using namespace std::chrono_literals;

TEST(TimeWindow, ALiveOneHasNowAtItsRightEdge) {
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

TEST(TimeWindow, AHeldOneStays) {
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

TEST(TimeWindow, ZoomHasItsLimits) {
  TimeWindow window;
  window.zoom(1e-12, -10);
  EXPECT_GT(window.to() - window.from(), 1e-5);
  window.zoom(1e20, -10);
  EXPECT_LT(window.to() - window.from(), 1e6);
}

TEST(TimeWindow, GoingLiveShowsTheLengthThatWasChosenLast) {
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

}  // namespace
}  // namespace tendon::gui
