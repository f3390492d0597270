#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tendon::benchmark {

/// How much is measured: enough for a verdict, or only enough to show that a case runs.
struct Effort {
  int repetitions = 31;
  bool is_tiny = false;

  [[nodiscard]] std::uint64_t Times(std::uint64_t times) const {
    return is_tiny ? std::max<std::uint64_t>(times / 1000, 1) : times;
  }
};

/// The result of one repetition: our time and the floor's, measured directly after each other for
/// some milliseconds each. Smaller is better; only a throughput without a floor is itself `ours`.
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

/// The medians of the repetitions. The ratio is the median of the ratios of pairs, so that slow
/// changes, such as the distance between the processors, cancel out.
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
std::vector<Case> RecordingCases(const Effort& effort);
/// The cases between two processes; none in a build without Ice.
std::vector<Case> NetworkCases(const Effort& effort);
/// The cases of the window; none in a build without it.
std::vector<Case> PlotCases(const Effort& effort);
std::vector<Case> WindowCases(const Effort& effort);

}  // namespace tendon::benchmark
