#pragma once

#include <tendon/payload/payload.h>

#include <chrono>
#include <cstdint>
#include <vector>

namespace tendon {

enum class SchedulingPolicy : std::int32_t {
  kNormal,
  kFifo,        ///< SCHED_FIFO: runs until it sleeps
  kRoundRobin,  ///< SCHED_RR: shares with threads of the same priority
};

/// Options of a task's own thread, applied at each start. Options that the machine refuses are
/// ignored, with one warning per process.
struct ThreadOptions {
  SchedulingPolicy policy = SchedulingPolicy::kNormal;
  std::int32_t priority = 0;       ///< 1 to 99 for kFifo and kRoundRobin, else 0
  std::vector<std::int32_t> cpus;  ///< the processors it may run on, 0 to 1023; empty: any
  bool lock_memory = false;        ///< locks the memory of the whole process
  std::uint64_t stack_bytes = 0;   ///< stack to touch before the first cycle; at most 4 MiB
  /// How late a sleep may end, to save power: 1 ns to 100 ms. It also delays the stop of the task.
  std::chrono::nanoseconds timer_slack{1};
  /// Periodic tasks wake earlier by this time, at most 1 s, and spin until the cycle is due.
  std::chrono::nanoseconds spin{0};

  bool operator==(const ThreadOptions&) const = default;
};

template <>
inline constexpr auto kPayload<SchedulingPolicy> =
    DescribeEnum("tendon.SchedulingPolicy", Enumerator{"normal", SchedulingPolicy::kNormal},
                 Enumerator{"fifo", SchedulingPolicy::kFifo},
                 Enumerator{"round_robin", SchedulingPolicy::kRoundRobin});

template <>
inline constexpr auto kPayload<ThreadOptions> = Describe(
    "tendon.ThreadOptions", Field{"policy", &ThreadOptions::policy},
    Field{"priority", &ThreadOptions::priority}, Field{"cpus", &ThreadOptions::cpus},
    Field{"lock_memory", &ThreadOptions::lock_memory},
    Field{"stack_bytes", &ThreadOptions::stack_bytes, "B"},
    Field{"timer_slack", &ThreadOptions::timer_slack}, Field{"spin", &ThreadOptions::spin});

}  // namespace tendon
