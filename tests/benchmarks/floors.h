#pragma once

#include <array>
#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <cstddef>
#include <cstdint>
#include <cstring>

/// What ours is compared with: the plainest thing that does the job, without our guarantees.
namespace tendon::benchmark {

using Message = std::array<double, 8>;  // 64 bytes
inline constexpr std::size_t kCapacity = 1024;

struct BoostRing {
  boost::lockfree::spsc_queue<Message, boost::lockfree::capacity<kCapacity>> ring;

  bool Push(const Message& message) { return ring.push(message); }
  bool Pop(Message& message) { return ring.pop(message); }
};

/// One value behind a sequence number, copied as a whole: fast and, in the language, a race.
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

}  // namespace tendon::benchmark
