#pragma once

#include <tendon/lockfree/slot_array.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace tendon {

/// A SlotRing for several producer threads: the same slots, in the order in which they were
/// claimed; one locked instruction a claim where nobody competes.
///
/// Thread safety: any threads call Claim() and Publish(), one thread Front() and Release(). A claim
/// is lock-free, all else wait-free. A producer that is held up between the two holds up what was
/// claimed after it, not the other producers.
///
/// Claims move the write index; each place in memory counts how often it was published. The slot of
/// an index is published when its place has been so once for every turn through the ring.
template <typename Atomics = StdAtomics>
class SharedSlotRing {
 public:
  /// As for SlotRing.
  SharedSlotRing(std::size_t capacity, std::size_t slot_size, std::size_t alignment,
                 std::size_t reserve = 0)
      : capacity_(capacity),
        reserve_(reserve),
        slots_(capacity + reserve, slot_size, alignment),
        turn_shift_(static_cast<unsigned>(std::countr_zero(storage()))),
        published_(std::make_unique<Index[]>(storage())) {}

  /// A free slot, which must be published; null when the ring is full.
  std::byte* Claim() noexcept { return ClaimWithin(capacity_); }
  /// The same, and full only when the reserve is used up as well.
  std::byte* ClaimReserved() noexcept { return ClaimWithin(capacity_ + reserve_); }

  /// Hands a claimed slot to the consumer.
  void Publish(const std::byte* slot) noexcept {
    Index& turns = published_[IndexOf(slot)];
    // Nobody else writes it meanwhile; (B) has brought the count of the turn before.
    turns.store(turns.load(std::memory_order_relaxed) + 1, std::memory_order_release);  // (A)
  }

  /// Consumer: the oldest slot, the same until Release(); null when it is not published yet.
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

  /// How many slots wait, claimed ones included. Any thread; exact when no side is at work.
  [[nodiscard]] std::size_t size() const noexcept {
    const std::uint64_t read = read_.load(std::memory_order_acquire);  // pairs with (B)
    return std::min<std::size_t>(write_.load(std::memory_order_relaxed) - read,
                                 capacity_ + reserve_);
  }
  /// How many slots the consumer has returned so far. Any thread.
  [[nodiscard]] std::uint64_t released() const noexcept {
    return read_.load(std::memory_order_relaxed);
  }
  [[nodiscard]] std::size_t capacity() const noexcept { return capacity_; }
  [[nodiscard]] std::size_t storage() const noexcept { return slots_.count_in_memory(); }

 private:
  using Index = typename Atomics::template Atomic<std::uint64_t>;

  std::byte* ClaimWithin(std::size_t limit) noexcept {
    // The exchange orders nothing: the slot is free by (B), and the consumer learns of it by (A).
    std::uint64_t write = write_.load(std::memory_order_relaxed);
    while (true) {
      const std::uint64_t read = read_.load(std::memory_order_acquire);  // pairs with (B)
      // An old `write` may lie before `read`; then the exchange fails and brings the newest.
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
