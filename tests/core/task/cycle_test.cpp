#include <gtest/gtest.h>
#include <tendon/base/error.h>
#include <tendon/task/cycle_grid.h>
#include <tendon/task/cycle_meter.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace {

using tendon::CycleGrid;
using tendon::CycleMeter;
using tendon::SteadyTime;
using tendon::TimeSpread;
using tendon::TimeStatistics;
using namespace std::chrono_literals;

constexpr SteadyTime kBegin(1h);

TEST(CycleGrid, AdvancesByWholePeriods) {
  CycleGrid grid(10ms);
  grid.Begin(kBegin);

  EXPECT_EQ(grid.due(), kBegin + 10ms);
  EXPECT_EQ(grid.Next(kBegin + 12ms), 0U);
  EXPECT_EQ(grid.due(), kBegin + 20ms);
  EXPECT_EQ(grid.Next(kBegin + 39ms), 0U);  // late by less than a period, so this cycle is executed
  EXPECT_EQ(grid.due(), kBegin + 30ms);
}

TEST(CycleGrid, SkipsAndCountsMissedPeriods) {
  CycleGrid grid(10ms);
  grid.Begin(kBegin);

  // Skips 20, 30 and 40 ms; the cycle of 50 ms is executed late.
  EXPECT_EQ(grid.Next(kBegin + 57ms), 3U);

  EXPECT_EQ(grid.due(), kBegin + 50ms);
  EXPECT_EQ(grid.Next(kBegin + 58ms), 0U);
  EXPECT_EQ(grid.due(), kBegin + 60ms);
}

TEST(TimeSpread, StartsEmptyAndClears) {
  TimeSpread spread;
  spread.Add(5ms);
  spread.Clear();

  EXPECT_EQ(spread.count(), 0U);
  EXPECT_EQ(spread.Summary().max, 0.0);
}

TEST(TimeSpread, KeepsSmallTimesExactly) {
  TimeSpread spread;
  for (const auto time : {4ns, 2ns, 9ns, -3ns}) spread.Add(time);

  const TimeStatistics summary = spread.Summary();

  EXPECT_DOUBLE_EQ(summary.mean, 3.75e-9);
  EXPECT_DOUBLE_EQ(summary.min, 0.0);
  EXPECT_DOUBLE_EQ(summary.max, 9e-9);
  EXPECT_DOUBLE_EQ(summary.p50, 2e-9);
  EXPECT_DOUBLE_EQ(summary.p99, 9e-9);
  EXPECT_NEAR(summary.deviation, std::sqrt(44.75 / 3.0) * 1e-9, 1e-18);
}

TEST(TimeSpread, ASingleTimeIsTheMeanWithoutDeviation) {
  TimeSpread spread;
  spread.Add(123456789ns);

  const TimeStatistics summary = spread.Summary();

  EXPECT_DOUBLE_EQ(summary.mean, 0.123456789);
  EXPECT_EQ(summary.deviation, 0.0);
  EXPECT_DOUBLE_EQ(summary.p50, 0.123456789);
}

TEST(TimeSpread, AgreesWithASortedListOverTwelveDecades) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(0.0, 12.0);
  TimeSpread spread;
  std::vector<double> all;
  double sum = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const std::chrono::nanoseconds time(
        static_cast<std::int64_t>(std::pow(10.0, exponent(random))));
    spread.Add(time);
    all.push_back(static_cast<double>(time.count()) / 1e9);
    sum += all.back();
  }
  std::sort(all.begin(), all.end());

  const TimeStatistics summary = spread.Summary();

  EXPECT_NEAR(summary.mean, sum / 10000.0, 1e-9 * summary.mean);
  EXPECT_NEAR(summary.p50, all[4999], 0.04 * all[4999]);
  EXPECT_NEAR(summary.p99, all[9899], 0.04 * all[9899]);
  EXPECT_DOUBLE_EQ(summary.min, all.front());
  EXPECT_DOUBLE_EQ(summary.max, all.back());
}

TEST(TimeSpread, AcceptsTimesBeyondItsBuckets) {
  TimeSpread spread;
  spread.Add(100h);
  spread.Add(200h);

  EXPECT_DOUBLE_EQ(spread.Summary().max, 720000.0);
  EXPECT_GE(spread.Summary().p99, 360000.0);
}

TEST(CycleMeter, MeasuresConsecutiveCycles) {
  CycleMeter meter;
  meter.Start(10ms);

  meter.Begin(kBegin + 1ms, kBegin);
  meter.End(kBegin + 3ms);
  EXPECT_EQ(meter.cycle().period, 0.0);
  EXPECT_DOUBLE_EQ(meter.cycle().lateness, 0.001);
  EXPECT_DOUBLE_EQ(meter.cycle().compute, 0.002);
  EXPECT_DOUBLE_EQ(meter.cycle().load, 0.2);

  meter.Begin(kBegin + 13ms, kBegin + 10ms);
  EXPECT_DOUBLE_EQ(meter.cycle().period, 0.012);
  meter.Interrupt();
  meter.Begin(kBegin + 1s, kBegin + 1s);
  EXPECT_EQ(meter.cycle().period, 0.0);
}

TEST(CycleMeter, SummarisesEachSecond) {
  CycleMeter meter;
  meter.Start(10ms);
  const auto cycle = [&meter](int number, std::chrono::nanoseconds lateness) {
    const SteadyTime due = kBegin + number * 10ms;
    meter.Begin(due + lateness, due);
    meter.End(due + lateness + 2ms);
  };

  for (int i = 0; i < 100; ++i) cycle(i, i == 50 ? 3ms : 0ms);
  EXPECT_EQ(meter.summary().cycles, 0U);
  cycle(100, 0ms);

  EXPECT_EQ(meter.summary().cycles, 100U);
  EXPECT_NEAR(meter.summary().period.mean, 0.010, 1e-9);
  EXPECT_NEAR(meter.summary().period.min, 0.007, 1e-9);
  EXPECT_NEAR(meter.summary().period.max, 0.013, 1e-9);
  EXPECT_NEAR(meter.summary().lateness.max, 0.003, 1e-9);
  EXPECT_EQ(meter.summary().lateness.p50, 0.0);
  EXPECT_NEAR(meter.summary().compute.mean, 0.002, 1e-9);

  for (int i = 101; i < 202; ++i) cycle(i, 1ms);
  EXPECT_EQ(meter.summary().cycles, 100U);
  EXPECT_NEAR(meter.summary().lateness.max, 0.001, 1e-9);  // the first second no longer counts
}

TEST(CycleMeter, ASlowTasksWindowHasTenCycles) {
  CycleMeter meter;
  meter.Start(1h);
  for (int i = 0; i < 10; ++i) {
    meter.Begin(kBegin + i * 1h, kBegin + i * 1h);
    meter.End(kBegin + i * 1h + 1s);
  }
  EXPECT_EQ(meter.summary().cycles, 0U);

  meter.Begin(kBegin + 10h, kBegin + 10h);

  EXPECT_EQ(meter.summary().cycles, 10U);
}

TEST(CycleMeter, AStartResetsTheMeter) {
  CycleMeter meter;
  meter.Start(10ms);
  meter.AddOverruns(7);
  for (int i = 0; i < 300; ++i) {
    meter.Begin(kBegin + i * 10ms, kBegin + i * 10ms);
    meter.End(kBegin + i * 10ms);
  }
  EXPECT_EQ(meter.cycle().overruns, 7U);

  meter.Start(10ms);

  EXPECT_EQ(meter.cycle().overruns, 0U);
  EXPECT_EQ(meter.summary().cycles, 0U);
}

}  // namespace
