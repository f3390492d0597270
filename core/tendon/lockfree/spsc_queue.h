#pragma once

#include <tendon/lockfree/slot_ring.h>

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

namespace tendon {

/// A bounded queue of values between one producer thread and one consumer thread: a SlotRing whose
/// slots hold a T each. Values are moved in and out, so do not use a T that allocates when it is
/// moved in a cycle.
///
/// Thread safety: one thread may call Push(), one other thread may call Pop(). Both are wait-free.
template <typename T, typename Atomics = StdAtomics>
class SpscQueue {
 public:
  static_assert(std::is_nothrow_move_constructible_v<T> && std::is_nothrow_move_assignable_v<T>);

  explicit SpscQueue(std::size_t capacity) : ring_(capacity, sizeof(T), alignof(T)) {}
  ~SpscQueue() {
    while (std::byte* slot = ring_.Front()) {
      std::destroy_at(Value(slot));
      ring_.Release();
    }
  }
  SpscQueue(const SpscQueue&) = delete;
  SpscQueue& operator=(const SpscQueue&) = delete;

  /// Returns false, and leaves the queue and `value` as they were, when the queue is full.
  bool Push(T&& value) noexcept {
    std::byte* slot = ring_.Claim();
    if (slot == nullptr) return false;
    new (slot) T(std::move(value));
    ring_.Publish();
    return true;
  }
  bool Push(const T& value) { return Push(T(value)); }

  /// Returns false, and leaves `value` as it was, when the queue is empty.
  bool Pop(T& value) noexcept {
    std::byte* slot = ring_.Front();
    if (slot == nullptr) return false;
    value = std::move(*Value(slot));
    std::destroy_at(Value(slot));
    ring_.Release();
    return true;
  }

  /// Any thread; exact while neither side is active.
  [[nodiscard]] std::size_t size() const noexcept { return ring_.size(); }
  [[nodiscard]] std::size_t capacity() const noexcept { return ring_.capacity(); }

 private:
  static T* Value(std::byte* slot) noexcept { return std::launder(reinterpret_cast<T*>(slot)); }

  SlotRing<Atomics, StrideOf(sizeof(T), alignof(T))> ring_;
};

}  // namespace tendon
