#pragma once

#include <tendon/payload/payload.h>

#include <chrono>
#include <cstdint>
#include <vector>

namespace tendon {

enum class SchedulingPolicy : std::int32_t {
  kNormal,
  kFifo,        ///< SCHED_FIFO: runs until it sleeps
  kRoundRobin,  ///< SCHED_RR: takes turns with threads of the same priority
};

/// The options of a task's own thread. They are applied at each start. If the machine refuses an
/// option, the option is ignored, and the process logs one warning.
struct ThreadOptions {
  SchedulingPolicy policy = SchedulingPolicy::kNormal;
  std::int32_t priority = 0;         ///< 1 to 99 for kFifo and kRoundRobin, otherwise 0
  std::vector<std::int32_t> cpus{};  ///< allowed processors, 0 to 1023; empty: all
  bool lock_memory = false;          ///< locks the memory of the whole process
  /// The number of stack bytes that are touched before the first cycle; at most 4 MiB.
  std::uint64_t stack_bytes = 0;
  /// The longest delay of a sleep, 1 ns to 100 ms. A long delay saves power, but a stop of the task
  /// may be delayed by the same time.
  std::chrono::nanoseconds timer_slack{1};
  /// A periodic task wakes up earlier by this time (at most 1 s), and spins until the cycle is due.
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
