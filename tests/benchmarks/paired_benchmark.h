#pragma once

#include <functional>
#include <string>
#include <vector>

namespace tendon::benchmark {

enum class Better { kLowerRatio, kHigherRatio };

/// What is measured: a function that runs one short repetition and returns what an operation took,
/// in nanoseconds.
struct Subject {
  std::function<double()> run;
  /// Processors it keeps busy when nothing disturbs it: a repetition that got less of them does not
  /// count.
  double processors = 1;
};

/// One line of PERFORMANCE.md: something of ours against a floor in the same program.
struct Case {
  std::string id;
  std::string what;
  Better better = Better::kLowerRatio;
  double gate = 0;
  double stretch = 0;
  Subject ours;
  Subject floor;
};

/// The medians of the repetitions. `ratio` is that of the paired ratios: ours to the floor in
/// nanoseconds, or in throughput where higher is better.
struct Outcome {
  double ours = 0;
  double floor = 0;
  double ratio = 0;
  int pairs = 0;      ///< that counted
  int disturbed = 0;  ///< that did not
};

/// Runs ours and the floor in turns, so that both see the same moods of the machine, until
/// `repetitions` pairs were undisturbed or ten seconds have passed.
Outcome Measure(const Case& one, int repetitions);

/// Measures all cases and prints a table. A missed gate is printed, never a failure: machines are
/// shared.
void Report(const std::vector<Case>& cases, int repetitions);

}  // namespace tendon::benchmark
