#pragma once

#include <tendon/lockfree/slot_array.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace tendon {

/// A SlotRing for several producer threads. The consumer gets the slots in the order in which they
/// were claimed. Without contention, a claim costs one locked instruction.
///
/// Thread safety: any threads call Claim() and Publish(), one thread Front() and Release(). Claim()
/// is lock-free, the others wait-free. A producer that is delayed between Claim() and Publish()
/// delays the consumption of slots that were claimed later, but not the other producers.
///
/// A claim increments the write index. Each slot in memory counts how often it was published. The
/// slot of an index is published when this count equals the number of turns through the ring.
template <typename Atomics = StdAtomics>
class SharedSlotRing {
 public:
  /// The parameters are the same as for SlotRing.
  SharedSlotRing(std::size_t capacity, std::size_t slot_size, std::size_t alignment,
                 std::size_t reserve = 0)
      : capacity_(capacity),
        reserve_(reserve),
        slots_(capacity + reserve, slot_size, alignment),
        turn_shift_(static_cast<unsigned>(std::countr_zero(storage()))),
        published_(std::make_unique<Index[]>(storage())) {}

  /// Claims and returns a free slot, which the caller must publish. Returns null if the ring is
  /// full.
  std::byte* Claim() noexcept { return ClaimWithin(capacity_); }
  /// Like Claim(), but may use the reserve. Returns null if the reserve is used up as well.
  std::byte* ClaimReserved() noexcept { return ClaimWithin(capacity_ + reserve_); }

  /// Hands a claimed slot to the consumer.
  void Publish(const std::byte* slot) noexcept {
    Index& turns = published_[IndexOf(slot)];
    // No other thread writes this count now; (B) has made the count of the previous turn visible.
    turns.store(turns.load(std::memory_order_relaxed) + 1, std::memory_order_release);  // (A)
  }

  /// Consumer: returns the oldest slot, and the same slot again until Release(). Returns null if
  /// the ring is empty or the oldest slot is not published yet.
  std::byte* Front() noexcept {
    const std::uint64_t read = read_.load(std::memory_order_relaxed);
    std::byte* const slot = slots_.At(read);
    const std::uint64_t turns = published_[IndexOf(slot)].load(std::memory_order_acquire);  // (A)
    return turns == (read >> turn_shift_) + 1 ? slot : nullptr;
  }

  /// Consumer: returns the front slot to the producers.
  void Release() noexcept {
    const std::uint64_t read = read_.load(std::memory_order_relaxed);
    read_.store(read + 1, std::memory_order_release);  // (B) returns the slot
  }

  [[nodiscard]] std::size_t IndexOf(const std::byte* slot) const noexcept {
    return slots_.IndexOf(slot);
  }

  /// Number of waiting slots, including claimed ones. Any thread; exact while no side is active.
  [[nodiscard]] std::size_t size() const noexcept {
    const std::uint64_t read = read_.load(std::memory_order_acquire);  // pairs with (B)
    return std::min<std::size_t>(write_.load(std::memory_order_relaxed) - read,
                                 capacity_ + reserve_);
  }
  /// Number of slots that the consumer has returned so far. Any thread.
  [[nodiscard]] std::uint64_t released() const noexcept {
    return read_.load(std::memory_order_relaxed);
  }
  [[nodiscard]] std::size_t capacity() const noexcept { return capacity_; }
  [[nodiscard]] std::size_t storage() const noexcept { return slots_.count_in_memory(); }

 private:
  using Index = typename Atomics::template Atomic<std::uint64_t>;

  std::byte* ClaimWithin(std::size_t limit) noexcept {
    // The exchange needs no ordering: (B) frees the slot, and (A) publishes it to the consumer.
    std::uint64_t write = write_.load(std::memory_order_relaxed);
    while (true) {
      const std::uint64_t read = read_.load(std::memory_order_acquire);  // pairs with (B)
      // A stale `write` may be less than `read`; then the exchange fails and loads the newest
      // value.
      const auto waiting = static_cast<std::int64_t>(write - read);
      if (waiting >= static_cast<std::int64_t>(limit)) return nullptr;
      if (write_.compare_exchange_weak(write, write + 1, std::memory_order_relaxed)) {
        return slots_.At(write);
      }
    }
  }

  std::size_t capacity_;
  std::size_t reserve_;
  SlotArray<> slots_;
  unsigned turn_shift_;
  std::unique_ptr<Index[]> published_;
  alignas(kSeparation) Index write_{0};
  alignas(kSeparation) Index read_{0};
};

}  // namespace tendon
