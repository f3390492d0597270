#pragma once

#include <tendon/lockfree/slot_array.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace tendon {

/// A bounded queue of raw slots between one producer thread and one consumer thread. The producer
/// constructs the content of a slot in place; the consumer uses and destroys it there.
///
/// All memory is allocated by the constructor. A ring with the capacity 64 can hold 64 full slots.
///
/// Thread safety: one thread calls Claim() and Publish(), one other thread calls Front() and
/// Release(). All four are wait-free. The indices are never reset: slots [read, write) belong to
/// the consumer, the others to the producer. Each side remembers the other's index and reads it
/// again only when the ring seems full or empty, which avoids most of the traffic between the two
/// cores.
template <typename Atomics = StdAtomics, std::size_t kStride = kAnyStride>
class SlotRing {
 public:
  /// `slot_size` in bytes; `alignment` is a power of two. `reserve` slots beyond the capacity are
  /// kept for ClaimReserved().
  SlotRing(std::size_t capacity, std::size_t slot_size, std::size_t alignment,
           std::size_t reserve = 0)
      : capacity_(capacity), reserve_(reserve), slots_(capacity + reserve, slot_size, alignment) {}

  /// Producer: returns the next free slot, and the same slot again until Publish(). Returns null if
  /// the ring is full.
  std::byte* Claim() noexcept { return ClaimWithin(capacity_); }
  /// Producer: like Claim(), but may use the reserve. Returns null if the reserve is used up as
  /// well.
  std::byte* ClaimReserved() noexcept { return ClaimWithin(capacity_ + reserve_); }

  /// Producer: hands the claimed slot to the consumer.
  void Publish() noexcept {
    const std::uint64_t write = producer_.write.load(std::memory_order_relaxed);
    producer_.write.store(write + 1, std::memory_order_release);  // (A) publishes the slot
  }

  /// Consumer: returns the oldest published slot, and the same slot again until Release(). Returns
  /// null if the ring is empty.
  std::byte* Front() noexcept {
    const std::uint64_t read = consumer_.read.load(std::memory_order_relaxed);
    if (read == consumer_.write_seen) {
      consumer_.write_seen = producer_.write.load(std::memory_order_acquire);  // pairs with (A)
      if (read == consumer_.write_seen) return nullptr;
    }
    return slots_.At(read);
  }

  /// Consumer: returns the front slot to the producer.
  void Release() noexcept {
    const std::uint64_t read = consumer_.read.load(std::memory_order_relaxed);
    consumer_.read.store(read + 1, std::memory_order_release);  // (B) returns the slot
  }

  /// Returns the number of a slot in memory, which is below storage(). It can be used as an index
  /// into a pool that has one element per slot.
  [[nodiscard]] std::size_t IndexOf(const std::byte* slot) const noexcept {
    return slots_.IndexOf(slot);
  }

  /// Number of waiting slots. Any thread; exact while neither side is active.
  [[nodiscard]] std::size_t size() const noexcept {
    const std::uint64_t read = consumer_.read.load(std::memory_order_acquire);    // pairs with (B)
    const std::uint64_t write = producer_.write.load(std::memory_order_acquire);  // pairs with (A)
    return std::min<std::size_t>(write - read, capacity_ + reserve_);
  }
  /// Number of slots that the consumer has returned so far. Any thread.
  [[nodiscard]] std::uint64_t released() const noexcept {
    return consumer_.read.load(std::memory_order_relaxed);
  }
  [[nodiscard]] std::size_t capacity() const noexcept { return capacity_; }
  /// Slots in memory: a power of two.
  [[nodiscard]] std::size_t storage() const noexcept { return slots_.count_in_memory(); }
  /// Bytes from one slot to the next.
  [[nodiscard]] std::size_t stride() const noexcept { return slots_.stride(); }

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

  std::byte* ClaimWithin(std::size_t limit) noexcept {
    const std::uint64_t write = producer_.write.load(std::memory_order_relaxed);
    if (write - producer_.read_seen >= limit) {
      producer_.read_seen = consumer_.read.load(std::memory_order_acquire);  // pairs with (B)
      if (write - producer_.read_seen >= limit) return nullptr;
    }
    return slots_.At(write);
  }

  std::size_t capacity_;
  std::size_t reserve_;
  SlotArray<kStride> slots_;
  Producer producer_;
  Consumer consumer_;
};

}  // namespace tendon
