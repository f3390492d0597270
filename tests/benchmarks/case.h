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

/// The result of one repetition: the time of Tendon (`ours`) and the time of the floor. Both are
/// measured one directly after the other, for some milliseconds each. Smaller is better. For a
/// throughput without a floor, `ours` is the throughput.
struct Pair {
  double ours = 0;
  std::optional<double> floor;  ///< empty if the goal is an absolute number
  bool is_disturbed = false;    ///< other programs used the processor during the measurement
};

enum class Ratio {
  kOfTimes,        ///< ours / floor; at most the gate
  kOfThroughputs,  ///< floor / ours; at least the gate
};

/// One line of the report.
struct Case {
  std::string id;
  std::string what;
  std::string unit = "ns";
  Ratio ratio = Ratio::kOfTimes;
  std::optional<double> gate;     ///< if empty, the case is only reported
  std::optional<double> stretch;  ///< the goal for later
  /// returns no value if this machine cannot measure the case
  std::function<std::optional<Pair>()> repetition;
  bool runs_once = false;
};

/// The medians of the repetitions. The ratio is the median of the ratios of pairs, so that slow
/// changes, such as the distance between the processors, cancel out.
struct Outcome {
  double ours = 0;
  std::optional<double> floor;
  double ratio = 0;
  int pairs = 0;
  /// Number of disturbed pairs; the medians ignore them if there are enough other pairs.
  int disturbed = 0;
};

// The cases, by subject.
std::vector<Case> QueueCases(const Effort& effort);
std::vector<Case> WaitingCases(const Effort& effort);
std::vector<Case> TableCases(const Effort& effort);
std::vector<Case> PeriodCases(const Effort& effort);
std::vector<Case> RecordingCases(const Effort& effort);
/// The cases between two processes; none in a build without Ice.
std::vector<Case> NetworkCases(const Effort& effort);
/// The cases of the window; none in a build without the window.
std::vector<Case> PlotCases(const Effort& effort);
std::vector<Case> WindowCases(const Effort& effort);

}  // namespace tendon::benchmark
