#pragma once

#include <tendon/base/clock.h>
#include <tendon/payload/payload.h>

#include <cstdint>

namespace tendon {

/// How the last cycle of a task went; the column `Cycle` of its default state table.
struct CycleStatistics {
  double period = 0.0;         ///< s from the cycle before to this one; 0 in the first
  double lateness = 0.0;       ///< s after the time it was due
  double compute = 0.0;        ///< s that the cycle before has computed
  double load = 0.0;           ///< compute / wanted period
  std::uint64_t overruns = 0;  ///< cycles skipped since the start because one took too long
};

template <>
inline constexpr auto kPayload<CycleStatistics> =
    Describe("tendon.CycleStatistics", Field{"period", &CycleStatistics::period, "s"},
             Field{"lateness", &CycleStatistics::lateness, "s"},
             Field{"compute", &CycleStatistics::compute, "s"},
             Field{"load", &CycleStatistics::load}, Field{"overruns", &CycleStatistics::overruns});

}  // namespace tendon
