#include <gtest/gtest.h>
#include <tendon/middleware/one_shot_value.h>

#include <thread>

namespace tendon {
namespace {

using std::chrono::hours;

TEST(OneShotValue, DeliversTheValue) {
  OneShotValue<int> handover;
  std::thread giver([&] { EXPECT_TRUE(handover.Give(7)); });

  EXPECT_EQ(handover.WaitUntil(SteadyClock().Now() + hours(1)), 7);
  giver.join();
}

TEST(OneShotValue, TimesOutAndRefusesALateValue) {
  OneShotValue<int> handover;

  EXPECT_EQ(handover.WaitUntil(SteadyClock().Now()), std::nullopt);
  EXPECT_FALSE(handover.Give(7));
}

TEST(OneShotValue, AcceptsOnlyTheFirstValue) {
  OneShotValue<int> handover;

  EXPECT_TRUE(handover.Give(7));
  EXPECT_FALSE(handover.Give(8));
  EXPECT_EQ(handover.WaitUntil(SteadyClock().Now()), 7);
}

}  // namespace
}  // namespace tendon
