#include <benchmarks/paired_benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <optional>

namespace tendon::benchmark {
namespace {

using Clock = std::chrono::steady_clock;

double Median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// Nothing when other programs took processor time away from the repetition.
std::optional<double> RunUndisturbed(const Subject& subject) {
  constexpr double kShare = 0.9;
  const std::clock_t used = std::clock();
  const auto start = Clock::now();
  const double nanoseconds = subject.run();
  const std::chrono::duration<double> wall = Clock::now() - start;
  const double busy = static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC;
  if (busy < kShare * subject.processors * wall.count()) return std::nullopt;
  return nanoseconds;
}

const char* Verdict(const Case& one, const Outcome& outcome, int repetitions) {
  if (outcome.pairs < repetitions) return "disturbed";  // too few pairs to say anything
  if (one.gate == 0) return "reported";
  const auto reaches = [&](double goal) {
    return one.better == Better::kLowerRatio ? outcome.ratio <= goal : outcome.ratio >= goal;
  };
  if (reaches(one.stretch)) return "stretch";
  return reaches(one.gate) ? "gate" : "MISSED";
}

}  // namespace

Outcome Measure(const Case& one, int repetitions) {
  constexpr std::chrono::seconds kPatience(10);
  std::vector<double> ours;
  std::vector<double> floors;
  std::vector<double> ratios;
  Outcome outcome;
  one.ours.run();  // warms caches and pages
  one.floor.run();
  const auto start = Clock::now();
  while (outcome.pairs < repetitions && Clock::now() - start < kPatience) {
    const auto our_time = RunUndisturbed(one.ours);
    const auto floor_time = RunUndisturbed(one.floor);
    if (!our_time || !floor_time) {
      ++outcome.disturbed;
      continue;
    }
    ++outcome.pairs;
    ours.push_back(*our_time);
    floors.push_back(*floor_time);
    const double ratio = *our_time / *floor_time;
    ratios.push_back(one.better == Better::kLowerRatio ? ratio : 1 / ratio);
  }
  outcome.ours = Median(ours);
  outcome.floor = Median(floors);
  outcome.ratio = Median(ratios);
  return outcome;
}

void Report(const std::vector<Case>& cases, int repetitions) {
  std::printf("%-4s %-42s %8s %8s %6s %6s %7s  %-9s %s\n", "case", "", "ours ns", "floor ns",
              "ratio", "gate", "stretch", "verdict", "pairs (disturbed)");
  for (const Case& one : cases) {
    const Outcome outcome = Measure(one, repetitions);
    std::printf("%-4s %-42s %8.2f %8.2f %6.2f %6.2f %7.2f  %-9s %d (%d)\n", one.id.c_str(),
                one.what.c_str(), outcome.ours, outcome.floor, outcome.ratio, one.gate, one.stretch,
                Verdict(one, outcome, repetitions), outcome.pairs, outcome.disturbed);
    std::fflush(stdout);
  }
}

}  // namespace tendon::benchmark
