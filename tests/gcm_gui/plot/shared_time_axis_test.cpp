#include <gcm_gui/plot/shared_time_axis.h>
#include <gmock/gmock.h>

namespace tendon::gui {
namespace {

using Gesture = SharedTimeAxis::Gesture;

/// Returns a set with one curve, so that it has an axis.
CurveSet OneAxis(const char* path = "p/a/state.x") {
  CurveSet set;
  set.add({path, "rad"});
  return set;
}

TEST(SharedTimeAxis, GoesBackAndForwardInItsHistory) {
  SharedTimeAxis axis;
  CurveSet set = OneAxis();
  axis.join(set);
  axis.remember(Gesture::kOnce);
  axis.window().show(-20, -10);
  set.axes()[0].range = {.low = 3, .high = 4};
  set.axes()[0].fitted = false;

  axis.goBack();
  EXPECT_TRUE(axis.window().isLive());
  EXPECT_TRUE(set.axes()[0].fitted);

  axis.goForward();
  EXPECT_EQ(axis.window().from(), -20);
  EXPECT_EQ(set.axes()[0].range, (AxisRange{.low = 3, .high = 4}));
  EXPECT_FALSE(axis.hasLater());
}

TEST(SharedTimeAxis, ARepeatedGestureIsOneStep) {
  SharedTimeAxis axis;
  for (int i = 0; i < 5; ++i) {
    axis.remember(Gesture::kZoomTime);
    axis.window().zoom(0.8, -10);
  }
  axis.remember(Gesture::kMove);
  axis.window().pan(-1);

  axis.goBack();
  EXPECT_NEAR(axis.window().to() - axis.window().from(), 30 * 0.32768, 1e-9);
  axis.goBack();
  EXPECT_TRUE(axis.window().isLive());
  EXPECT_FALSE(axis.hasFormer());
}

TEST(SharedTimeAxis, EndingARunStartsANewStep) {
  SharedTimeAxis axis;
  axis.remember(Gesture::kMove);
  axis.window().pan(-1);
  axis.endRun();
  axis.remember(Gesture::kMove);
  axis.window().pan(-1);

  axis.goBack();

  EXPECT_FALSE(axis.window().isLive());
  EXPECT_TRUE(axis.hasFormer());
}

TEST(SharedTimeAxis, ANewStepClearsTheForwardHistory) {
  SharedTimeAxis axis;
  axis.remember(Gesture::kOnce);
  axis.window().show(-20, -10);
  axis.goBack();
  ASSERT_TRUE(axis.hasLater());

  axis.remember(Gesture::kOnce);
  axis.window().show(-5, -4);

  EXPECT_FALSE(axis.hasLater());
}

TEST(SharedTimeAxis, RemembersABoundedNumberOfSteps) {
  SharedTimeAxis axis;
  for (std::size_t i = 0; i < 2 * SharedTimeAxis::kMaxSteps; ++i) axis.remember(Gesture::kOnce);

  std::size_t steps = 0;
  for (; axis.hasFormer(); ++steps) axis.goBack();

  EXPECT_EQ(steps, SharedTimeAxis::kMaxSteps);
}

TEST(SharedTimeAxis, GoingBackIgnoresPlotsThatLeft) {
  SharedTimeAxis axis;
  CurveSet stays = OneAxis();
  axis.join(stays);
  {
    CurveSet leaves = OneAxis();
    axis.join(leaves);
    axis.remember(Gesture::kOnce);
    axis.leave(leaves);
  }
  stays.axes()[0].fitted = false;

  axis.goBack();

  EXPECT_TRUE(stays.axes()[0].fitted);
}

}  // namespace
}  // namespace tendon::gui
