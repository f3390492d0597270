#include <gtest/gtest.h>
#include <tendon/process/log/log_limiter.h>

#include <string>
#include <vector>

namespace {

using tendon::LogLevel;
using tendon::LogLimiter;
using tendon::SteadyTime;
using SuppressedCount = LogLimiter::SuppressedCount;
using namespace std::chrono_literals;

/// A limiter with a clock that the test advances.
class LogLimiterTest : public testing::Test {
 protected:
  bool Admits(const std::string& source, LogLevel level = LogLevel::kInfo) {
    return limiter.Admit(source, level, clock.Now());
  }
  /// Returns how many of `count` simultaneous records are admitted.
  int Admitted(const std::string& source, int count) {
    int admitted = 0;
    for (int i = 0; i < count; ++i) admitted += Admits(source) ? 1 : 0;
    return admitted;
  }

  tendon::ManualClock clock;
  LogLimiter limiter{{.burst = 5, .interval = 10ms}};
};

TEST_F(LogLimiterTest, AdmitsABurstThenOnePerInterval) {
  EXPECT_EQ(Admitted("arm", 20), 5);

  clock.Advance(9ms);
  EXPECT_EQ(Admitted("arm", 20), 0);
  clock.Advance(1ms);
  EXPECT_EQ(Admitted("arm", 20), 1);
  clock.Advance(30ms);
  EXPECT_EQ(Admitted("arm", 20), 3);
}

TEST_F(LogLimiterTest, AdmitsABurstAgainAfterSilence) {
  ASSERT_EQ(Admitted("arm", 20), 5);

  clock.Advance(1h);

  EXPECT_EQ(Admitted("arm", 20), 5);
}

TEST_F(LogLimiterTest, AdmitsEverySourceWithinTheRate) {
  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(Admits("arm")) << i;
    clock.Advance(10ms);
  }
  EXPECT_FALSE(limiter.owes());
}

TEST_F(LogLimiterTest, LimitsEachSourceSeparately) {
  ASSERT_EQ(Admitted("arm", 100000), 5);

  EXPECT_EQ(Admitted("gripper", 5), 5);
}

TEST_F(LogLimiterTest, ReportsSuppressionOnceWithinASecond) {
  ASSERT_EQ(Admitted("arm", 12), 5);
  EXPECT_FALSE(Admits("arm", LogLevel::kError));
  EXPECT_FALSE(Admits("arm", LogLevel::kDebug));
  EXPECT_TRUE(limiter.TakeSuppressed(clock.Now()).empty());
  EXPECT_TRUE(limiter.owes());

  clock.Advance(LogLimiter::kUntilReport);

  EXPECT_EQ(limiter.TakeSuppressed(clock.Now()),
            (std::vector<SuppressedCount>{{"arm", LogLevel::kError, 9}}));
  EXPECT_TRUE(limiter.TakeSuppressed(clock.Now()).empty());
  EXPECT_FALSE(limiter.owes());
}

TEST_F(LogLimiterTest, ForgetsTheLevelAfterReporting) {
  ASSERT_EQ(Admitted("arm", 5), 5);
  ASSERT_FALSE(Admits("arm", LogLevel::kError));
  ASSERT_EQ(limiter.TakeSuppressed(SteadyTime::max()).size(), 1U);

  ASSERT_FALSE(Admits("arm", LogLevel::kDebug));

  EXPECT_EQ(limiter.TakeSuppressed(SteadyTime::max()),
            (std::vector<SuppressedCount>{{"arm", LogLevel::kDebug, 1}}));
}

TEST_F(LogLimiterTest, ReportsAllSuppressionAtTheEnd) {
  Admitted("arm", 7);
  Admitted("gripper", 6);

  EXPECT_EQ(
      limiter.TakeSuppressed(SteadyTime::max()),
      (std::vector<SuppressedCount>{{"arm", LogLevel::kInfo, 2}, {"gripper", LogLevel::kInfo, 1}}));
}

TEST_F(LogLimiterTest, CombinesExcessSources) {
  for (std::size_t i = 0; i < LogLimiter::kMaxSources; ++i) {
    ASSERT_TRUE(Admits("source " + std::to_string(i)));
  }
  int admitted = 0;
  for (int i = 0; i < 1000; ++i) admitted += Admits("another " + std::to_string(i)) ? 1 : 0;

  EXPECT_EQ(admitted, 5);
  EXPECT_EQ(
      limiter.TakeSuppressed(SteadyTime::max()),
      (std::vector<SuppressedCount>{{std::string(LogLimiter::kOthers), LogLevel::kInfo, 995}}));
}

TEST_F(LogLimiterTest, ReusesTheBucketsOfSilentSources) {
  for (std::size_t i = 0; i < LogLimiter::kMaxSources; ++i) Admits(std::to_string(i));

  clock.Advance(1h);

  EXPECT_EQ(Admitted("arm", 20), 5);
  EXPECT_EQ(Admitted("gripper", 20), 5);
}

TEST_F(LogLimiterTest, DistinguishesSourcesByTheirVisibleName) {
  const std::string name(LogLimiter::kLongestSource, 'x');

  EXPECT_EQ(Admitted(name + "a", 3), 3);
  EXPECT_EQ(Admitted(name + "b", 3), 2);
}

}  // namespace
