#include <benchmarks/measurement.h>
#include <benchmarks/seat.h>

#include <algorithm>
#include <ctime>
#include <thread>
#include <utility>

namespace tendon::benchmark {
namespace {

using Clock = std::chrono::steady_clock;

struct Run {
  double nanoseconds = 0;
  bool is_disturbed = false;
};

/// Returns the processor time in seconds.
double ProcessorTime(const Subject& subject) {
  const double here = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  return subject.elsewhere ? here + subject.elsewhere() : here;
}

Run RunOnce(const Subject& subject) {
  constexpr double kShare = 0.9;
  const double used = ProcessorTime(subject);
  const auto start = Clock::now();
  const double nanoseconds = subject.run();
  const std::chrono::duration<double> wall = Clock::now() - start;
  const double busy = ProcessorTime(subject) - used;
  return {nanoseconds, busy < kShare * subject.processors * wall.count()};
}

double Median(std::vector<double> values) {
  constexpr double kHalf = 0.5;
  return Quantile(std::move(values), kHalf);
}

double RatioOf(const Case& one, const Pair& pair) {
  if (!pair.floor) return pair.ours;
  return one.ratio == Ratio::kOfTimes ? pair.ours / *pair.floor : *pair.floor / pair.ours;
}

Outcome Summary(const Case& one, const std::vector<Pair>& pairs, int wanted) {
  const auto disturbed = std::ranges::count_if(pairs, &Pair::is_disturbed);
  const auto total = static_cast<std::ptrdiff_t>(pairs.size());
  const bool takes_all = total - disturbed < wanted;
  std::vector<double> ours;
  std::vector<double> floors;
  std::vector<double> ratios;
  for (const Pair& pair : pairs) {
    if (pair.is_disturbed && !takes_all) continue;
    ours.push_back(pair.ours);
    if (pair.floor) floors.push_back(*pair.floor);
    ratios.push_back(RatioOf(one, pair));
  }
  Outcome outcome{.ours = Median(ours), .ratio = Median(ratios)};
  if (!floors.empty()) outcome.floor = Median(floors);
  outcome.pairs = static_cast<int>(total);
  outcome.disturbed = static_cast<int>(disturbed);
  return outcome;
}

}  // namespace

double Quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto place = static_cast<std::ptrdiff_t>(static_cast<double>(values.size()) * share);
  std::ranges::nth_element(values, values.begin() + place);
  return values[static_cast<std::size_t>(place)];
}

std::function<std::optional<Pair>()> SideBySide(Subject ours, Subject floor) {
  return [ours = std::move(ours), floor = std::move(floor), ours_is_first = false,
          is_warm = false]() mutable {
    const Seat seat(Processor::kFirst);
    if (!std::exchange(is_warm, true)) {  // warms up caches and pages
      ours.run();
      floor.run();
    }
    ours_is_first = !ours_is_first;
    Run our_run;
    if (ours_is_first) our_run = RunOnce(ours);
    const Run floor_run = RunOnce(floor);
    if (!ours_is_first) our_run = RunOnce(ours);
    return std::optional<Pair>({.ours = our_run.nanoseconds,
                                .floor = floor_run.nanoseconds,
                                .is_disturbed = our_run.is_disturbed || floor_run.is_disturbed});
  };
}

std::optional<Outcome> Measure(const Case& one, const Effort& effort) {
  constexpr std::chrono::seconds kMaxTime(10);
  // Lets other programs run, and keeps below the kernel's limit for real-time threads.
  constexpr std::chrono::milliseconds kPause(2);
  const int wanted = one.runs_once ? 1 : effort.repetitions;
  const auto start = Clock::now();
  std::vector<Pair> pairs;
  for (int undisturbed = 0; undisturbed < wanted;) {
    const auto pair = one.repetition();
    if (!pair) return std::nullopt;
    pairs.push_back(*pair);
    if (!pair->is_disturbed) ++undisturbed;
    const bool has_enough = std::ssize(pairs) >= wanted;
    if (has_enough && (effort.is_tiny || Clock::now() - start > kMaxTime)) break;
    std::this_thread::sleep_for(kPause);
  }
  return Summary(one, pairs, wanted);
}

}  // namespace tendon::benchmark
