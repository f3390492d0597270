#pragma once

#include <cstdint>

namespace tendon_test {

/// Counts what a thread does that it must not do between wake-up and sleep: allocate, free, lock,
/// call the operating system. It disarms itself while the thread sleeps in clock_nanosleep or
/// waits on a futex by syscall(), and arms itself when it wakes.
///
/// For programs that are linked with real_time_guard.cpp, which stands before some functions of the
/// C library. Where the kernel can trap system calls of a thread (Linux 5.11, x86-64) every one is
/// seen, else those by syscall(). Reading the clock is allowed. Not together with sanitizers.
class RealTimeGuard {
 public:
  struct Counts {
    std::uint64_t allocations = 0;
    std::uint64_t locks = 0;
    std::uint64_t system_calls = 0;
    long last_system_call = -1;  // its number
    std::uint64_t sleeps = 0;    // how often the thread has been disarmed and armed again
  };

  /// Whether this build has a guard, and whether it sees every system call.
  static bool IsAvailable();
  static bool SeesEverySystemCall();

  /// From now on the calling thread is guarded.
  static void Arm();
  /// It is no more; what has been counted since.
  static Counts Disarm();
};

}  // namespace tendon_test
