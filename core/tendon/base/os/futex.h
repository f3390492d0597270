#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

namespace tendon::os {

/// Sleeps while `word` holds `expected`, until woken or until `timeout` has passed. Spurious
/// wake-ups are possible. One system call.
void FutexWait(const std::atomic<std::uint32_t>& word, std::uint32_t expected,
               std::chrono::nanoseconds timeout) noexcept;

/// Wakes every thread that sleeps on `word`. One system call.
void FutexWake(const std::atomic<std::uint32_t>& word) noexcept;

/// Executes a full memory barrier in every running thread of this process, so that the other
/// threads need no barrier in their code. If the kernel refuses, executes only a fence in the
/// calling thread and logs this once. Takes microseconds; not for a cycle.
void ProcessBarrier() noexcept;

}  // namespace tendon::os
