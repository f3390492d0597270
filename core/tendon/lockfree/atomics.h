#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/os/futex.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <thread>

namespace tendon {

/// Distance in bytes between data that two threads write: two cache lines, because processors fetch
/// them in pairs.
inline constexpr std::size_t kSeparation = 128;
inline constexpr std::size_t kCacheLine = 64;

/// The operations of the machine that lock-free classes use. Each class is a template over such a
/// policy, so that the same source also runs under the interleaving simulator of tests/support.
struct StdAtomics {
  template <typename T>
  using Atomic = std::atomic<T>;

  static void Fence(std::memory_order order) noexcept { std::atomic_thread_fence(order); }
  /// A fence for the compiler only. The other thread must call ProcessBarrier(), which is a fence
  /// for the processors as well.
  static void CompilerFence() noexcept { std::atomic_signal_fence(std::memory_order_seq_cst); }
  /// Executes a full fence in every thread of the process. Takes microseconds.
  static void ProcessBarrier() noexcept { os::ProcessBarrier(); }

  static void Sleep(const std::atomic<std::uint32_t>& word, std::uint32_t expected,
                    std::chrono::nanoseconds timeout) noexcept {
    os::FutexWait(word, expected, timeout);
  }
  static void Wake(const std::atomic<std::uint32_t>& word) noexcept { os::FutexWake(word); }

  /// Waits between two checks of a spin loop: yields at first, later sleeps.
  static void Pause(unsigned looks) noexcept {
    constexpr unsigned kYields = 64;
    constexpr std::chrono::microseconds kNap(50);
    if (looks < kYields) {
      std::this_thread::yield();
    } else {
      std::this_thread::sleep_for(kNap);
    }
  }

  static SteadyTime Now() noexcept { return std::chrono::steady_clock::now(); }
};

}  // namespace tendon
