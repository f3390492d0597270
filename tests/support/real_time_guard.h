#pragma once

#include <cstdint>

namespace tendon_test {

/// Counts the actions that a real-time thread must not do between wake-up and sleep: allocating,
/// freeing, locking, and system calls. Does not count while the thread sleeps in clock_nanosleep(),
/// or waits on a futex by syscall().
///
/// Use it only in programs that are linked with real_time_guard.cpp, which replaces some functions
/// of the C library. If the kernel can trap a thread's system calls (Linux 5.11, x86-64), all
/// system calls are counted; otherwise only those made by syscall(). Reading the clock is allowed.
/// Does not work with sanitizers.
class RealTimeGuard {
 public:
  struct Counts {
    std::uint64_t allocations = 0;
    std::uint64_t locks = 0;
    std::uint64_t system_calls = 0;
    long last_system_call = -1;  // the number of the last system call
    std::uint64_t sleeps = 0;    // how often the thread has slept
  };

  /// The first value is true if this build has a guard, the second if the guard sees every system
  /// call.
  static bool IsAvailable();
  static bool SeesEverySystemCall();

  /// Guards the calling thread from now on.
  static void Arm();
  /// Ends the guard and returns the counts.
  static Counts Disarm();
};

}  // namespace tendon_test
