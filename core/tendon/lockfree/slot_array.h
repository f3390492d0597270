#pragma once

#include <tendon/lockfree/atomics.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace tendon {

/// Returns the number of bytes from one slot of a ring to the next. It is at least a cache line,
/// and a multiple of the alignment.
constexpr std::size_t StrideOf(std::size_t slot_size, std::size_t alignment) {
  alignment = std::max(alignment, kCacheLine);
  return std::max((slot_size + alignment - 1) & ~(alignment - 1), alignment);
}
inline constexpr std::size_t kAnyStride = 0;

/// The memory of a ring: aligned slots, whose number is a power of two. The constructor allocates
/// it. Slots are found faster if the compiler knows the stride.
template <std::size_t kStride = kAnyStride>
class SlotArray {
 public:
  /// Room for `count` slots; `slot_size` in bytes; `alignment` is a power of two.
  SlotArray(std::size_t count, std::size_t slot_size, std::size_t alignment)
      : mask_(std::bit_ceil(std::max<std::size_t>(count, 1)) - 1),
        stride_(StrideOf(slot_size, alignment)),
        shift_(static_cast<unsigned>(std::countr_zero(stride_))) {
    assert(std::has_single_bit(alignment));
    assert(kStride == kAnyStride || kStride == stride_);
    alignment = std::max(alignment, kCacheLine);
    inverse_ = InverseOfOdd(stride_ >> shift_);
    std::size_t size = count_in_memory() * stride_ + alignment;
    memory_ = std::make_unique<std::byte[]>(size);
    void* first = memory_.get();
    slots_ =
        static_cast<std::byte*>(std::align(alignment, count_in_memory() * stride_, first, size));
  }

  /// Returns the slot for an index. Indices grow without limit and go round the ring.
  [[nodiscard]] std::byte* At(std::uint64_t index) const noexcept {
    return slots_ + (index & mask_) * stride();
  }
  /// Returns the number of a slot in memory, which is below count_in_memory().
  [[nodiscard]] std::size_t IndexOf(const std::byte* slot) const noexcept {
    // Divides exactly by the stride: by a shift and a multiplication with the inverse of its odd
    // part, modulo 2^64.
    return (static_cast<std::size_t>(slot - slots_) >> shift_) * inverse_;
  }
  [[nodiscard]] std::size_t count_in_memory() const noexcept { return mask_ + 1; }
  /// Bytes from one slot to the next.
  [[nodiscard]] std::size_t stride() const noexcept {
    return kStride != kAnyStride ? kStride : stride_;
  }

 private:
  static constexpr std::size_t InverseOfOdd(std::size_t odd) {
    std::size_t inverse = odd;  // three correct bits; each Newton step doubles their number
    for (int step = 0; step < 5; ++step) inverse *= 2 - odd * inverse;
    return inverse;
  }

  std::size_t mask_;
  std::size_t stride_;
  unsigned shift_;
  std::size_t inverse_ = 1;
  std::unique_ptr<std::byte[]> memory_;
  std::byte* slots_ = nullptr;
};

}  // namespace tendon
