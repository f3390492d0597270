#pragma once

#include <cstdint>

namespace tendon_test {

/// Counts the actions that a real-time thread must not do between wake-up and sleep: allocating,
/// freeing, locking, and system calls. It does not count while the thread sleeps in clock_nanosleep
/// or waits on a futex by syscall().
///
/// For programs linked with real_time_guard.cpp, which interposes some functions of the C library.
/// If the kernel can trap a thread's system calls (Linux 5.11, x86-64), all of them are counted;
/// otherwise only those made by syscall(). Reading the clock is allowed. Does not work with
/// sanitizers.
class RealTimeGuard {
 public:
  struct Counts {
    std::uint64_t allocations = 0;
    std::uint64_t locks = 0;
    std::uint64_t system_calls = 0;
    long last_system_call = -1;  // its number
    std::uint64_t sleeps = 0;    // how often it was disarmed and armed again
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
