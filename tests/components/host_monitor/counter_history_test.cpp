#include <components/host_monitor/counter_history.h>
#include <gtest/gtest.h>

namespace host {
namespace {

using namespace std::chrono_literals;

/// Returns a sample at `time` after the first sample. All its counters have the value `count`.
CounterSample SampleAt(std::chrono::milliseconds time, std::uint64_t count) {
  return {.time = tendon::SteadyTime(5s) + time,
          .cpu = {.total = {count, 2 * count}, .cores = {{count, 4 * count}, {count, count}}},
          .disk = {.read = count << 20U, .written = count << 19U},
          .network = {.received = count << 10U, .sent = count << 11U, .loopback = count << 12U}};
}

Cpu LoadOf(const CounterHistory& history) {
  Cpu cpu{.total = -1.0, .cores = {-1.0, -1.0}};
  history.Rate(cpu);
  return cpu;
}

TEST(CounterHistory, HasNoRatesWithoutTwoSamples) {
  CounterHistory history;
  EXPECT_EQ(LoadOf(history).total, 0.0);
  EXPECT_EQ(history.disk().read, 0.0);

  history.Add(SampleAt(0ms, 100));

  EXPECT_EQ(LoadOf(history).total, 0.0);
  EXPECT_EQ(history.disk().read, 0.0);
  EXPECT_EQ(history.network().sent, 0.0);
}

TEST(CounterHistory, DividesByTheElapsedTime) {
  CounterHistory history;
  history.Add(SampleAt(0ms, 100));
  history.Add(SampleAt(250ms, 110));

  EXPECT_DOUBLE_EQ(history.disk().read, 40.0);
  EXPECT_DOUBLE_EQ(history.disk().written, 20.0);
  EXPECT_DOUBLE_EQ(history.network().received, 40.0);
  EXPECT_DOUBLE_EQ(history.network().sent, 80.0);
  EXPECT_DOUBLE_EQ(history.network().loopback, 160.0);
}

TEST(CounterHistory, LoadIsTheBusyShare) {
  CounterHistory history;
  history.Add(SampleAt(0ms, 100));
  history.Add(SampleAt(50ms, 110));

  EXPECT_DOUBLE_EQ(LoadOf(history).total, 50.0);
  EXPECT_DOUBLE_EQ(LoadOf(history).cores[0], 25.0);
  EXPECT_DOUBLE_EQ(LoadOf(history).cores[1], 100.0);
}

TEST(CounterHistory, AveragesOverOneSecond) {
  CounterHistory history;
  std::uint64_t count = 0;
  for (int i = 0; i <= 40; ++i) history.Add(SampleAt(i * 50ms, count += i <= 20 ? 100 : 1));

  EXPECT_DOUBLE_EQ(history.disk().read, 20.0);  // only the quiet second counts
}

TEST(CounterHistory, BridgesALongGap) {
  CounterHistory history;
  history.Add(SampleAt(0ms, 0));
  history.Add(SampleAt(50ms, 10));
  history.Add(SampleAt(10'050ms, 110));

  EXPECT_DOUBLE_EQ(history.disk().read, 10.0);
}

TEST(CounterHistory, ADecreasingCounterHasNoRate) {
  CounterHistory history;
  history.Add(SampleAt(0ms, 100));
  history.Add(SampleAt(50ms, 10));

  EXPECT_EQ(LoadOf(history).total, 0.0);
  EXPECT_EQ(history.disk().read, 0.0);
  EXPECT_EQ(history.network().loopback, 0.0);
}

TEST(CounterHistory, HandlesAChangingNumberOfCores) {
  CounterHistory history;
  CounterSample one_core = SampleAt(0ms, 100);
  one_core.cpu.cores.resize(1);
  history.Add(one_core);
  CounterSample many_cores = SampleAt(50ms, 110);
  many_cores.cpu.cores.resize(8);
  history.Add(many_cores);

  EXPECT_DOUBLE_EQ(LoadOf(history).cores[0], 25.0);
  EXPECT_EQ(LoadOf(history).cores[1], 0.0);
}

}  // namespace
}  // namespace host
