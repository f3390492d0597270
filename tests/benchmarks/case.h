#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tendon::benchmark {

/// How much is measured: what a verdict needs, or so little that it only shows that a case runs.
struct Effort {
  int repetitions = 31;
  bool is_tiny = false;

  [[nodiscard]] std::uint64_t Times(std::uint64_t times) const {
    return is_tiny ? std::max<std::uint64_t>(times / 1000, 1) : times;
  }
};

/// What one repetition found, ours and the floor measured one right after the other, some
/// milliseconds each; smaller is better.
struct Pair {
  double ours = 0;
  std::optional<double> floor;  ///< nothing where the goal is a number of its own
  bool is_disturbed = false;    ///< other programs took processor time away from it
};

enum class Ratio {
  kOfTimes,        ///< ours / floor; at most the gate
  kOfThroughputs,  ///< the other way round; at least the gate
};

/// One line of the report.
struct Case {
  std::string id;
  std::string what;
  std::string unit = "ns";
  Ratio ratio = Ratio::kOfTimes;
  std::optional<double> gate;                       ///< without one it is only reported
  std::optional<double> stretch;                    ///< where we go next
  std::function<std::optional<Pair>()> repetition;  ///< nothing where this machine cannot tell
  bool runs_once = false;
};

/// The medians of the repetitions; the ratio is that of the paired ratios, so that what changes
/// slowly, such as how far the processors are from each other, cancels out.
struct Outcome {
  double ours = 0;
  std::optional<double> floor;
  double ratio = 0;
  int pairs = 0;
  int disturbed = 0;  ///< of them; left out of the medians if there are enough others
};

// The cases, by what they are about.
std::vector<Case> QueueCases(const Effort& effort);
std::vector<Case> WaitingCases(const Effort& effort);
std::vector<Case> TableCases(const Effort& effort);
std::vector<Case> PeriodCases(const Effort& effort);
/// Between two processes; none where Ice is not built in.
std::vector<Case> NetworkCases(const Effort& effort);
/// Of the window; none where it is not built in.
std::vector<Case> PlotCases(const Effort& effort);
std::vector<Case> WindowCases(const Effort& effort);

}  // namespace tendon::benchmark
