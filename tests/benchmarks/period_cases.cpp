#include <benchmarks/measurement.h>
#include <tendon/base/os/thread.h>
#include <tendon/manager/local_manager.h>
#include <tendon/task/periodic_task.h>
#include <time.h>

#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <thread>

namespace tendon::benchmark {
namespace {

using namespace std::chrono_literals;

constexpr std::chrono::nanoseconds kPeriod = 1ms;
constexpr int kPriority = 50;

class Ticker final : public PeriodicTask {
 public:
  explicit Ticker(std::string name) : PeriodicTask(std::move(name), kPeriod) {
    SetThreadOptions({.policy = SchedulingPolicy::kFifo, .priority = kPriority});
  }
  ~Ticker() override { Join(); }

 private:
  void Run() override {}
};

/// A 1 kHz task that does nothing, and its state table with the timing of the cycles.
class RunningTicker {
 public:
  RunningTicker() : ticker_(manager_.Add<Ticker>("ticker")) { (void)manager_.StartAll(); }

  /// Calls `visit(stamp, statistics)` for every cycle since the last call.
  template <typename Visitor>
  void VisitCycles(Visitor visit) {
    const StateTable& table = *ticker_.tables().front();
    const auto& column = dynamic_cast<const Column<CycleStatistics>&>(*table.Find("Cycle"));
    CycleStatistics statistics;
    std::uint64_t lost = 0;
    next_ = column.ReadSince(next_, statistics, lost, visit);
  }

 private:
  LocalManager manager_;
  Ticker& ticker_;
  std::uint64_t next_ = 0;
};

/// Measures how late a simple periodic loop wakes, in nanoseconds.
std::vector<double> RunBareLoop(std::chrono::nanoseconds window) {
  std::vector<double> late;
  std::jthread loop([&] {
    (void)os::SetRealTimePriority(kPriority, true);
    os::SetTimerSlack(1);
    const auto now = [] {
      timespec time{};
      clock_gettime(CLOCK_MONOTONIC, &time);
      return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
    };
    const auto end = now() + window;
    // Wakes half a period after the task, so that the loop does not disturb the task.
    for (auto due = now() / kPeriod * kPeriod + kPeriod * 3 / 2; due < end; due += kPeriod) {
      const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(due);
      const timespec time{.tv_sec = seconds.count(), .tv_nsec = (due - seconds).count()};
      clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr);
      late.push_back(static_cast<double>((now() - due).count()));
    }
  });
  loop.join();
  return late;
}

/// Measures both in the same window, so that disturbances affect both.
Pair CompareLateness(RunningTicker& ticker, std::chrono::nanoseconds window, double share) {
  std::vector<double> ours;
  ticker.VisitCycles([](const auto&, const auto&) {});  // drops the cycles before the window
  const std::vector<double> bare = RunBareLoop(window);
  ticker.VisitCycles([&](const RowStamp& /*stamp*/, const CycleStatistics& cycle) {
    ours.push_back(cycle.lateness * 1e9);
  });
  return {.ours = Quantile(ours, share), .floor = Quantile(bare, share)};
}

double SlopeOf(const std::vector<double>& x, const std::vector<double>& y) {
  const auto mean = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  const double x_mean = mean(x);
  const double y_mean = mean(y);
  double xy = 0;
  double xx = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - x_mean) * (y[i] - y_mean);
    xx += (x[i] - x_mean) * (x[i] - x_mean);
  }
  return xy / xx;
}

/// Returns the relative error of the period, including skipped cycles.
Pair MeasurePeriodError(std::chrono::milliseconds duration) {
  constexpr auto kLook = 100ms;  // the table holds a second
  RunningTicker ticker;
  std::vector<double> indices;
  std::vector<double> times;
  for (auto passed = 0ms; passed < duration; passed += kLook) {
    std::this_thread::sleep_for(kLook);
    ticker.VisitCycles([&](const RowStamp& stamp, const CycleStatistics& cycle) {
      const auto time = std::chrono::duration<double>(stamp.time.time_since_epoch());
      indices.push_back(static_cast<double>(stamp.tick + cycle.overruns));
      times.push_back(time.count());
    });
  }
  const double period = std::chrono::duration<double>(kPeriod).count();
  return {.ours = std::abs(SlopeOf(indices, times) / period - 1)};
}

}  // namespace

std::vector<Case> PeriodCases(const Effort& effort) {
  const auto window = effort.is_tiny ? 20ms : 250ms;
  const auto duration = effort.is_tiny ? 200ms : 20'000ms;
  // Only one ticker exists at a time.
  const auto ticker = std::make_shared<std::optional<RunningTicker>>();
  const auto lateness = [=](double share) {
    return [=] {
      if (!*ticker) ticker->emplace();
      return std::optional(CompareLateness(**ticker, window, share));
    };
  };
  return {
      {.id = "P1",
       .what = "1 kHz task, p50 lateness / raw loop",
       .gate = 1.05,
       .stretch = 1.02,
       .repetition = lateness(0.5)},
      {.id = "P1-p99", .what = "the same, p99", .stretch = 1.2, .repetition = lateness(0.99)},
      {.id = "P4",
       .what = "1 kHz task, error of the period",
       .unit = "1",
       .gate = 1e-5,
       .repetition =
           [=] {
             ticker->reset();
             return std::optional(MeasurePeriodError(duration));
           },
       .runs_once = true},
  };
}

}  // namespace tendon::benchmark
