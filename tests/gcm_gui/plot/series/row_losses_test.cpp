#include <gcm_gui/plot/series/row_losses.h>
#include <gtest/gtest.h>

namespace tendon::gui {
namespace {

TEST(RowLosses, AreCountedSinceAnEarlierMoment) {
  const RowLosses before{.table = 5, .network = 2, .viewer = 1};
  const RowLosses now{.table = 8, .network = 2, .viewer = 3};

  EXPECT_EQ(now.since(before), (RowLosses{.table = 3, .network = 0, .viewer = 2}));
  EXPECT_EQ(now.since({}), now);
}

TEST(RowLosses, OfANewSubscriptionAreNeverNegative) {
  const RowLosses before{.table = 5, .network = 2, .viewer = 1};

  EXPECT_EQ((RowLosses{.table = 1}).since(before), RowLosses());
}

TEST(RowLosses, AreListedWithTheirPlaces) {
  const RowLosses losses{.table = 600, .network = 3, .viewer = 7};

  EXPECT_EQ(LossPlaces(losses, "%1 in this window"),
            "600 in its process, 3 on the network, 7 in this window");
  EXPECT_EQ(LossPlaces({.viewer = 7}, "%1 here"), "7 here");
  EXPECT_EQ(LossPlaces({}, "%1 here"), "");
}

}  // namespace
}  // namespace tendon::gui
