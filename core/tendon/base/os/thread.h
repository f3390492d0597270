#pragma once

#include <tendon/base/clock.h>

#include <chrono>
#include <cstdint>
#include <string>

namespace tendon::os {

/// The kernel's name of the calling thread, cut to 15 letters; seen in top and in a debugger.
void NameThisThread(const std::string& name) noexcept;

/// Sleeps until an absolute time of the steady clock; at once when it has passed.
void SleepUntil(SteadyTime time) noexcept;

/// The least lateness the kernel may add to a sleep of this thread, in nanoseconds (50 µs if never
/// set).
void SetTimerSlack(std::uint64_t nanoseconds) noexcept;

/// SCHED_FIFO at `priority` (1 to 99) for the calling thread; false where it is not allowed.
bool SetRealTimePriority(int priority) noexcept;

/// How much processor time the calling thread has used; does not advance while it waits.
[[nodiscard]] std::chrono::nanoseconds ThreadCpuTime() noexcept;

}  // namespace tendon::os
