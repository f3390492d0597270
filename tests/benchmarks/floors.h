#pragma once

#include <benchmarks/measurement.h>
#include <tendon/base/os/futex.h>

#include <array>
#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <thread>

/// The simplest code that does the same job without the guarantees of Tendon. The benchmarks
/// compare Tendon with it.
namespace tendon::benchmark {

using Message = std::array<double, 8>;  // 64 bytes
inline constexpr std::size_t kCapacity = 1024;

struct BoostRing {
  boost::lockfree::spsc_queue<Message, boost::lockfree::capacity<kCapacity>> ring;

  bool Push(const Message& message) { return ring.push(message); }
  bool Pop(Message& message) { return ring.pop(message); }
};

/// A value and a sequence number; the value is copied as a whole. Fast, but a data race by the
/// rules of C++.
template <typename T>
class Seqlock {
 public:
  void Store(const T& value) {
    const auto sequence = sequence_.load(std::memory_order_relaxed);
    sequence_.store(sequence + 1, std::memory_order_relaxed);
    std::atomic_thread_fence(std::memory_order_release);
    std::memcpy(&value_, &value, sizeof(T));
    sequence_.store(sequence + 2, std::memory_order_release);
  }
  void Load(T& value) const {
    while (true) {
      const auto before = sequence_.load(std::memory_order_acquire);
      std::memcpy(&value, &value_, sizeof(T));
      std::atomic_thread_fence(std::memory_order_acquire);
      if (before % 2 == 0 && sequence_.load(std::memory_order_relaxed) == before) return;
    }
  }

 private:
  alignas(64) std::atomic<std::uint64_t> sequence_ = 0;
  T value_{};
};

/// Two threads that wake each other in turns.
inline double WakeInTurns(std::uint64_t rounds) {
  constexpr std::chrono::seconds kTimeout(1);
  const auto last = static_cast<std::uint32_t>(2 * rounds);
  std::atomic<std::uint32_t> turn = 0;
  const auto await = [&](std::uint32_t mine) {
    for (std::uint32_t now = turn; now < mine; now = turn) os::FutexWait(turn, now, kTimeout);
  };
  const auto pass_on = [&](std::uint32_t next) {
    turn = next;
    os::FutexWake(turn);
  };
  std::jthread other([&] {
    for (std::uint32_t mine = 1; mine < last; mine += 2) {
      await(mine);
      pass_on(mine + 1);
    }
  });
  return NanosecondsEach(rounds, [&](std::uint64_t i) {
    const auto mine = static_cast<std::uint32_t>(2 * i);
    pass_on(mine + 1);
    await(mine + 2);
  });
}

}  // namespace tendon::benchmark
