#pragma once

#include <tendon/base/clock.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace tendon::os {

/// The kernel's name of the calling thread, cut to 15 letters; seen in top and in a debugger.
void NameThisThread(const std::string& name) noexcept;

/// Sleeps until an absolute time of the steady clock; at once when it has passed.
void SleepUntil(SteadyTime time) noexcept;

/// The least lateness the kernel may add to a sleep of this thread, in nanoseconds (50 µs if never
/// set).
void SetTimerSlack(std::uint64_t nanoseconds) noexcept;

/// Whether the kernel has done what was asked, and if not, its reason.
struct Permission {
  bool granted = true;
  std::string reason;
};

/// SCHED_FIFO, or SCHED_RR, at `priority` (1 to 99) for the calling thread.
Permission SetRealTimePriority(int priority, bool is_fifo);

/// Binds the calling thread to these processors, numbered from 0.
Permission RunOnProcessors(std::span<const std::int32_t> processors);

/// How many processors the machine has, used or not.
[[nodiscard]] int ProcessorCount() noexcept;

/// Keeps all pages of the process in memory, those to come as well.
Permission LockMemory();

/// Writes to that much of the calling thread's stack, so that no page of it is missing later.
void TouchStack(std::size_t bytes) noexcept;

/// How much processor time the calling thread has used; does not advance while it waits.
[[nodiscard]] std::chrono::nanoseconds ThreadCpuTime() noexcept;

}  // namespace tendon::os
