#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/os/futex.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <thread>

namespace tendon {

/// Keeps what two threads write apart: two cache lines, since processors fetch lines in pairs.
inline constexpr std::size_t kSeparation = 128;
inline constexpr std::size_t kCacheLine = 64;

/// How lock-free classes reach the machine. Each of them is a template over such a policy, so that
/// the same source runs under the interleaving simulator of tests/support.
struct StdAtomics {
  template <typename T>
  using Atomic = std::atomic<T>;

  static void Fence(std::memory_order order) noexcept { std::atomic_thread_fence(order); }
  /// Binds the compiler only; the other side makes up for it with ProcessBarrier().
  static void CompilerFence() noexcept { std::atomic_signal_fence(std::memory_order_seq_cst); }
  /// A full fence in every thread of the process. Microseconds.
  static void ProcessBarrier() noexcept { os::ProcessBarrier(); }

  static void Sleep(const std::atomic<std::uint32_t>& word, std::uint32_t expected,
                    std::chrono::nanoseconds timeout) noexcept {
    os::FutexWait(word, expected, timeout);
  }
  static void Wake(const std::atomic<std::uint32_t>& word) noexcept { os::FutexWake(word); }

  /// Between two looks at what another thread will change: yields first, then sleeps.
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
