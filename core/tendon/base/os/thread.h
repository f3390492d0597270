#pragma once

#include <tendon/base/clock.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace tendon::os {

/// Names the calling thread, cut to 15 letters; shown by top and by debuggers.
void NameThisThread(const std::string& name) noexcept;

/// Sleeps until an absolute time of the steady clock; returns at once if it has passed.
void SleepUntil(SteadyTime time) noexcept;

/// Sets how late the kernel may end a sleep of the calling thread, in nanoseconds (50 µs by
/// default).
void SetTimerSlack(std::uint64_t nanoseconds) noexcept;

/// The outcome of a request to the kernel: granted, or the reason why it is not granted.
struct Permission {
  bool granted = true;
  std::string reason;
};

/// Schedules the calling thread with SCHED_FIFO, or SCHED_RR if not `is_fifo`, at `priority` (1 to
/// 99).
Permission SetRealTimePriority(int priority, bool is_fifo);

/// Lowers the priority of the calling thread below that of usual threads. For threads that can
/// wait.
void LowerPriority() noexcept;

/// Binds the calling thread to these processors, numbered from 0.
Permission RunOnProcessors(std::span<const std::int32_t> processors);

/// Number of processors of the machine, used or not.
[[nodiscard]] int ProcessorCount() noexcept;

/// Keeps all pages of the process in memory, including future ones.
Permission LockMemory();

/// Writes to `bytes` of the calling thread's stack, so that none of its pages causes a page fault
/// later.
void TouchStack(std::size_t bytes) noexcept;

/// Processor time of the calling thread. It does not advance while the thread waits.
[[nodiscard]] std::chrono::nanoseconds ThreadCpuTime() noexcept;

}  // namespace tendon::os
