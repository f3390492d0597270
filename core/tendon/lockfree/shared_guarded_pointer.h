#pragma once

#include <tendon/lockfree/atomics.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace tendon {

/// A GuardedPointer for several calling threads. Each call costs two locked instructions.
///
/// Thread safety: any thread makes Calls, which may be nested. One thread at a time uses Exchange()
/// and Get(), never inside a Call.
///
/// There are two counters of running calls. The lowest bit of the pointer says which counter
/// belongs to the object, and changes with each exchange. A call increments the counter, then reads
/// the pointer again; if the pointer has changed, the call starts over. Therefore, all calls in the
/// old counter use the old object, and the exchange waits only for these calls.
template <typename T, typename Atomics = StdAtomics>
class SharedGuardedPointer {
 public:
  explicit SharedGuardedPointer(T* initial = nullptr) noexcept : pointer_(WordOf(initial, 0)) {}
  SharedGuardedPointer(const SharedGuardedPointer&) = delete;
  SharedGuardedPointer& operator=(const SharedGuardedPointer&) = delete;

  /// While this object exists, the object of get() is not freed.
  class [[nodiscard]] Call {
   public:
    explicit Call(SharedGuardedPointer& guarded) noexcept
        : guarded_(guarded), word_(guarded.pointer_.load(std::memory_order_relaxed)) {
      while (true) {
        running().fetch_add(1, std::memory_order_relaxed);
        Atomics::Fence(std::memory_order_seq_cst);  // pairs with (C): counted before the load
        const std::uintptr_t word = guarded_.pointer_.load(std::memory_order_acquire);  // (A)
        if (word == word_) return;
        running().fetch_sub(1, std::memory_order_release);
        word_ = word;
      }
    }
    ~Call() { running().fetch_sub(1, std::memory_order_release); }  // (B) done with the object
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

    /// May be null.
    [[nodiscard]] T* get() const noexcept { return ObjectOf(word_); }

   private:
    typename Atomics::template Atomic<std::uint32_t>& running() const noexcept {
      return guarded_.running_[PlaceOf(word_)];
    }

    SharedGuardedPointer& guarded_;
    std::uintptr_t word_;
  };

  /// Makes `next` the object of all further calls, waits until no call uses the old object, and
  /// returns it; the caller may free it. Takes as long as the longest call that uses the old
  /// object.
  T* Exchange(T* next) noexcept {
    const std::uintptr_t old = pointer_.load(std::memory_order_relaxed);
    const std::size_t place = PlaceOf(old);
    pointer_.store(WordOf(next, 1 - place), std::memory_order_release);  // (A) publishes the object
    Atomics::Fence(std::memory_order_seq_cst);  // (C) published before counters are read
    for (unsigned looks = 0; running_[place].load(std::memory_order_acquire) != 0; ++looks) {
      Atomics::Pause(looks);  // the load above pairs with (B)
    }
    return ObjectOf(old);
  }

  /// Returns the current object. Only for the threads that call Exchange().
  [[nodiscard]] T* Get() const noexcept {
    return ObjectOf(pointer_.load(std::memory_order_acquire));
  }

 private:
  static std::uintptr_t WordOf(T* object, std::size_t place) noexcept {
    static_assert(alignof(T) >= 2);
    return reinterpret_cast<std::uintptr_t>(object) | place;
  }
  static std::size_t PlaceOf(std::uintptr_t word) noexcept { return word & 1U; }
  static T* ObjectOf(std::uintptr_t word) noexcept {
    return reinterpret_cast<T*>(word & ~std::uintptr_t{1});
  }

  typename Atomics::template Atomic<std::uintptr_t> pointer_;  // its lowest bit selects the counter
  std::array<typename Atomics::template Atomic<std::uint32_t>, 2> running_{};
};

}  // namespace tendon
