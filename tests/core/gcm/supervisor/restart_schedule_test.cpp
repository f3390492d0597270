#include <gtest/gtest.h>
#include <tendon/gcm/supervisor/restart_schedule.h>

namespace tendon::server {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

constexpr SteadyTime kBegin = SteadyTime() + 1h;

/// The process runs for `life` and then fails. Returns the pause before its restart.
std::optional<std::chrono::milliseconds> FailAfter(std::chrono::nanoseconds life, SteadyTime& now,
                                                   RestartSchedule& schedule) {
  const SteadyTime begin = now;
  now += life;
  const auto pause = schedule.PauseAfter(begin, now);
  if (pause) now += *pause;
  return pause;
}

TEST(RestartSchedule, DoublesThePauseUpToALimit) {
  RestartSchedule schedule;
  SteadyTime now = kBegin;

  for (const auto pause : {500ms, 1000ms, 2000ms, 4000ms, 8000ms, 10000ms, 10000ms}) {
    EXPECT_EQ(FailAfter(14s, now, schedule), pause);
  }
}

TEST(RestartSchedule, RestartsThePausesAfterAStableMinute) {
  RestartSchedule schedule;
  SteadyTime now = kBegin;
  FailAfter(1s, now, schedule);
  FailAfter(1s, now, schedule);

  EXPECT_EQ(FailAfter(1min, now, schedule), 500ms);
  EXPECT_EQ(FailAfter(1min - 1ms, now, schedule), 1000ms);
}

TEST(RestartSchedule, GivesUpAtTheFifthFailureWithinAMinute) {
  RestartSchedule schedule;
  SteadyTime now = kBegin;
  for (int failure = 1; failure < 5; ++failure) EXPECT_TRUE(FailAfter(0s, now, schedule));

  EXPECT_EQ(FailAfter(0s, now, schedule), std::nullopt);
}

}  // namespace
}  // namespace tendon::server
