#pragma once

#include <tendon/lockfree/atomics.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace tendon {

/// A GuardedPointer for several calling threads; two locked instructions a call.
///
/// Thread safety: Calls by any threads (nested ones too); Exchange() and Get() by one thread at a
/// time, never from inside a call.
///
/// Calls are counted in one of two places, which the exchange swaps, so that those that begin while
/// it waits do not hold it up. It waits until it has seen each place at zero: a call that has the
/// old pointer was counted before the pointer changed, and stays so until it ends.
template <typename T, typename Atomics = StdAtomics>
class SharedGuardedPointer {
 public:
  explicit SharedGuardedPointer(T* initial = nullptr) noexcept : pointer_(initial) {}
  SharedGuardedPointer(const SharedGuardedPointer&) = delete;
  SharedGuardedPointer& operator=(const SharedGuardedPointer&) = delete;

  /// While it lives, what get() gives is not freed.
  class [[nodiscard]] Call {
   public:
    explicit Call(SharedGuardedPointer& guarded) noexcept
        : running_(guarded.running_[guarded.place_.load(std::memory_order_relaxed)]) {
      running_.fetch_add(1, std::memory_order_relaxed);
      Atomics::Fence(std::memory_order_seq_cst);  // pairs with (C): counted, then loaded
      object_ = guarded.pointer_.load(std::memory_order_acquire);  // pairs with (A)
    }
    ~Call() { running_.fetch_sub(1, std::memory_order_release); }  // (B) done with the object
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

    /// May be null.
    [[nodiscard]] T* get() const noexcept { return object_; }

   private:
    typename Atomics::template Atomic<std::uint32_t>& running_;
    T* object_;
  };

  /// Makes `next` the object of all further calls, waits until no call uses the old one, and
  /// returns that: the caller may free it. As long as the longest current call.
  T* Exchange(T* next) noexcept {
    T* const old = pointer_.load(std::memory_order_relaxed);
    pointer_.store(next, std::memory_order_release);  // (A) publishes the object
    Atomics::Fence(std::memory_order_seq_cst);        // (C) the pointer is out, then calls are seen
    const std::size_t first = place_.load(std::memory_order_relaxed);
    for (const std::size_t place : {first, 1 - first}) {
      place_.store(1 - place, std::memory_order_relaxed);
      for (unsigned looks = 0; running_[place].load(std::memory_order_acquire) != 0; ++looks) {
        Atomics::Pause(looks);  // the load above pairs with (B)
      }
    }
    return old;
  }

  /// For the side that replaces.
  [[nodiscard]] T* Get() const noexcept { return pointer_.load(std::memory_order_acquire); }

 private:
  typename Atomics::template Atomic<T*> pointer_;
  typename Atomics::template Atomic<std::size_t> place_{0};
  std::array<typename Atomics::template Atomic<std::uint32_t>, 2> running_{};
};

}  // namespace tendon
