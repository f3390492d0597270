#pragma once

#include <tendon/lockfree/atomics.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace tendon {

/// A bounded queue of raw slots between one producer thread and one consumer thread. What lies in a
/// slot is made, used and destroyed in place by its users.
///
/// All memory is allocated by the constructor. A capacity of 64 holds 64.
///
/// Thread safety: one thread calls Claim() and Publish(), one other Front() and Release(); all are
/// wait-free. They work on indices that are never reset: slots [read, write) are the consumer's,
/// the others the producer's. Each side remembers the other's index and looks again only when it
/// seems full or empty, which spares most of the traffic between the two cores.
template <typename Atomics = StdAtomics>
class SlotRing {
 public:
  /// `slot_size` in bytes; `alignment` is a power of two. Slots lie at least a cache line apart.
  SlotRing(std::size_t capacity, std::size_t slot_size, std::size_t alignment)
      : capacity_(capacity), mask_(std::bit_ceil(std::max<std::size_t>(capacity, 1)) - 1) {
    assert(std::has_single_bit(alignment));
    alignment = std::max(alignment, kCacheLine);
    stride_ = std::max((slot_size + alignment - 1) & ~(alignment - 1), alignment);
    shift_ = static_cast<unsigned>(std::countr_zero(stride_));
    inverse_ = InverseOfOdd(stride_ >> shift_);
    std::size_t size = storage() * stride_ + alignment;
    memory_ = std::make_unique<std::byte[]>(size);
    void* first = memory_.get();
    slots_ = static_cast<std::byte*>(std::align(alignment, storage() * stride_, first, size));
  }

  /// Producer: the next free slot, the same until Publish(); null when the ring is full.
  std::byte* Claim() noexcept {
    const std::uint64_t write = producer_.write.load(std::memory_order_relaxed);
    if (write - producer_.read_seen >= capacity_) {
      producer_.read_seen = consumer_.read.load(std::memory_order_acquire);  // pairs with (B)
      if (write - producer_.read_seen >= capacity_) return nullptr;
    }
    return At(write);
  }

  /// Producer: hands the claimed slot to the consumer.
  void Publish() noexcept {
    const std::uint64_t write = producer_.write.load(std::memory_order_relaxed);
    producer_.write.store(write + 1, std::memory_order_release);  // (A) publishes the slot
  }

  /// Consumer: the oldest published slot, the same until Release(); null when the ring is empty.
  std::byte* Front() noexcept {
    const std::uint64_t read = consumer_.read.load(std::memory_order_relaxed);
    if (read == consumer_.write_seen) {
      consumer_.write_seen = producer_.write.load(std::memory_order_acquire);  // pairs with (A)
      if (read == consumer_.write_seen) return nullptr;
    }
    return At(read);
  }

  /// Consumer: returns the front slot to the producer.
  void Release() noexcept {
    const std::uint64_t read = consumer_.read.load(std::memory_order_relaxed);
    consumer_.read.store(read + 1, std::memory_order_release);  // (B) returns the slot
  }

  /// The number of a slot's place in memory, below storage(); it serves a pool beside the ring.
  [[nodiscard]] std::size_t IndexOf(const std::byte* slot) const noexcept {
    // Exact division by the stride: a shift and the inverse of its odd part, modulo 2^64.
    return (static_cast<std::size_t>(slot - slots_) >> shift_) * inverse_;
  }

  /// How many slots wait. Any thread; exact when neither side is at work.
  [[nodiscard]] std::size_t size() const noexcept {
    const std::uint64_t read = consumer_.read.load(std::memory_order_acquire);    // pairs with (B)
    const std::uint64_t write = producer_.write.load(std::memory_order_acquire);  // pairs with (A)
    return std::min<std::size_t>(write - read, capacity_);
  }
  [[nodiscard]] std::size_t capacity() const noexcept { return capacity_; }
  /// Slots in memory: the capacity rounded up to a power of two.
  [[nodiscard]] std::size_t storage() const noexcept { return mask_ + 1; }
  /// Bytes from one slot to the next.
  [[nodiscard]] std::size_t stride() const noexcept { return stride_; }

 private:
  using Index = typename Atomics::template Atomic<std::uint64_t>;

  struct alignas(kSeparation) Producer {
    Index write{0};
    std::uint64_t read_seen = 0;
  };
  struct alignas(kSeparation) Consumer {
    Index read{0};
    std::uint64_t write_seen = 0;
  };

  static constexpr std::size_t InverseOfOdd(std::size_t odd) {
    std::size_t inverse = odd;  // right in three bits; each Newton step doubles them
    for (int step = 0; step < 5; ++step) inverse *= 2 - odd * inverse;
    return inverse;
  }

  std::byte* At(std::uint64_t index) noexcept { return slots_ + (index & mask_) * stride_; }

  std::size_t capacity_;
  std::size_t mask_;
  std::size_t stride_ = 0;
  std::size_t inverse_ = 1;
  unsigned shift_ = 0;
  std::unique_ptr<std::byte[]> memory_;
  std::byte* slots_ = nullptr;
  Producer producer_;
  Consumer consumer_;
};

}  // namespace tendon
