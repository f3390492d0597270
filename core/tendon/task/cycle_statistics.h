#pragma once

#include <tendon/payload/payload.h>

#include <cstdint>

namespace tendon {

/// Statistics of a task's last cycle; the column `Cycle` of its default state table.
struct CycleStatistics {
  double period = 0.0;         ///< s from the start of the previous cycle; 0 in the first cycle
  double lateness = 0.0;       ///< s from the due time to the start of the cycle
  double compute = 0.0;        ///< s that the previous cycle took
  double load = 0.0;           ///< compute / wanted period; 0 if there is no period
  std::uint64_t overruns = 0;  ///< cycles skipped since the start, because others took too long
};

/// The distribution of a time over several cycles. The percentiles are accurate to 3 %.
struct TimeStatistics {
  double mean = 0.0;       ///< s
  double deviation = 0.0;  ///< s; standard deviation of the sample, 0 for a single cycle
  double min = 0.0;        ///< s
  double max = 0.0;        ///< s
  double p50 = 0.0;        ///< s
  double p99 = 0.0;        ///< s
};

/// Statistics over a window of at least one second and at least ten cycles; the column
/// `CycleSummary` of a task's default state table. The values are replaced when the next window is
/// full.
struct CycleSummary {
  std::uint64_t cycles = 0;  ///< cycles in the window; 0 until the first window is full
  TimeStatistics period;
  TimeStatistics lateness;
  TimeStatistics compute;
};

template <>
inline constexpr auto kPayload<CycleStatistics> =
    Describe("tendon.CycleStatistics", Field{"period", &CycleStatistics::period, "s"},
             Field{"lateness", &CycleStatistics::lateness, "s"},
             Field{"compute", &CycleStatistics::compute, "s"},
             Field{"load", &CycleStatistics::load}, Field{"overruns", &CycleStatistics::overruns});

template <>
inline constexpr auto kPayload<TimeStatistics> =
    Describe("tendon.TimeStatistics", Field{"mean", &TimeStatistics::mean, "s"},
             Field{"deviation", &TimeStatistics::deviation, "s"},
             Field{"min", &TimeStatistics::min, "s"}, Field{"max", &TimeStatistics::max, "s"},
             Field{"p50", &TimeStatistics::p50, "s"}, Field{"p99", &TimeStatistics::p99, "s"});

template <>
inline constexpr auto kPayload<CycleSummary> = Describe("tendon.CycleSummary",
                                                        Field{"cycles", &CycleSummary::cycles},
                                                        Field{"period", &CycleSummary::period},
                                                        Field{"lateness", &CycleSummary::lateness},
                                                        Field{"compute", &CycleSummary::compute});

}  // namespace tendon
