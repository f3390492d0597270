#include <gcm_gui/plot/link/time_link.h>
#include <gmock/gmock.h>

namespace tendon::gui {
namespace {

using Gesture = TimeLink::Gesture;

/// A set of one curve, so that it has an axis.
CurveSet OneAxis(const char* path = "p/a/state.x") {
  CurveSet set;
  set.add({path, "rad"});
  return set;
}

TEST(TimeLink, GoesBackAndForwardThroughTimeAndValues) {
  TimeLink link;
  CurveSet set = OneAxis();
  link.join(set);
  link.remember(Gesture::kOnce);
  link.window().show(-20, -10);
  set.axes()[0].range = {.low = 3, .high = 4};
  set.axes()[0].fitted = false;

  link.goBack();
  EXPECT_TRUE(link.window().isLive());
  EXPECT_TRUE(set.axes()[0].fitted);

  link.goForward();
  EXPECT_EQ(link.window().from(), -20);
  EXPECT_EQ(set.axes()[0].range, (AxisRange{.low = 3, .high = 4}));
  EXPECT_FALSE(link.hasLater());
}

TEST(TimeLink, ARunOfTheSameGestureIsOneStep) {
  TimeLink link;
  for (int i = 0; i < 5; ++i) {
    link.remember(Gesture::kZoomTime);
    link.window().zoom(0.8, -10);
  }
  link.remember(Gesture::kMove);
  link.window().pan(-1);

  link.goBack();
  EXPECT_NEAR(link.window().to() - link.window().from(), 30 * 0.32768, 1e-9);
  link.goBack();
  EXPECT_TRUE(link.window().isLive());
  EXPECT_FALSE(link.hasFormer());
}

TEST(TimeLink, ARunThatWasEndedIsAStepOfItsOwn) {
  TimeLink link;
  link.remember(Gesture::kMove);
  link.window().pan(-1);
  link.endRun();
  link.remember(Gesture::kMove);
  link.window().pan(-1);

  link.goBack();

  EXPECT_FALSE(link.window().isLive());
  EXPECT_TRUE(link.hasFormer());
}

TEST(TimeLink, ANewStepEndsTheWayForward) {
  TimeLink link;
  link.remember(Gesture::kOnce);
  link.window().show(-20, -10);
  link.goBack();
  ASSERT_TRUE(link.hasLater());

  link.remember(Gesture::kOnce);
  link.window().show(-5, -4);

  EXPECT_FALSE(link.hasLater());
}

TEST(TimeLink, RemembersABoundedNumberOfSteps) {
  TimeLink link;
  for (std::size_t i = 0; i < 2 * TimeLink::kMostSteps; ++i) link.remember(Gesture::kOnce);

  std::size_t steps = 0;
  for (; link.hasFormer(); ++steps) link.goBack();

  EXPECT_EQ(steps, TimeLink::kMostSteps);
}

TEST(TimeLink, APlotThatHasLeftIsNotTouchedByTheWayBack) {
  TimeLink link;
  CurveSet stays = OneAxis();
  link.join(stays);
  {
    CurveSet leaves = OneAxis();
    link.join(leaves);
    link.remember(Gesture::kOnce);
    link.leave(leaves);
  }
  stays.axes()[0].fitted = false;

  link.goBack();

  EXPECT_TRUE(stays.axes()[0].fitted);
}

}  // namespace
}  // namespace tendon::gui
