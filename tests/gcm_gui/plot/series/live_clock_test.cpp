#include <gcm_gui/plot/series/live_clock.h>
#include <gmock/gmock.h>

#include "../samples.h"

namespace tendon::gui {
namespace {

TEST(LiveClock, RunsEvenlyThoughSamplesComeInBatches) {
  LiveClock clock;
  const std::int64_t ahead = 77 * kSecond;
  for (std::int64_t local = 0; local < kSecond; local += 50 * kMillisecond) {
    clock.update(local + ahead, local);
    for (std::int64_t later = 0; later < 50; ++later) {
      EXPECT_EQ(clock.now(local + later * kMillisecond), local + later * kMillisecond + ahead);
    }
  }
}

TEST(LiveClock, ALateBatchDoesNotSetItBack) {
  LiveClock clock;
  clock.update(10 * kSecond, 10 * kSecond);

  clock.update(10 * kSecond + 20 * kMillisecond, 10 * kSecond + 400 * kMillisecond);

  EXPECT_EQ(clock.now(11 * kSecond), 11 * kSecond);
}

TEST(LiveClock, ContinuesWhenTheSourceIsSilent) {
  LiveClock clock;
  clock.update(10 * kSecond, 3 * kSecond);

  EXPECT_EQ(clock.now(100 * kSecond), 107 * kSecond);
}

TEST(LiveClock, DropsAnOutdatedLead) {
  LiveClock clock;
  clock.update(20 * kSecond, 10 * kSecond);
  for (int i = 1; i < 100; ++i) {
    const std::int64_t local = 10 * kSecond + i * 100 * kMillisecond;
    clock.update(local + 5 * kSecond, local);
  }

  EXPECT_EQ(clock.now(30 * kSecond), 35 * kSecond);
}

}  // namespace
}  // namespace tendon::gui
