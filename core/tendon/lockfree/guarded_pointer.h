#pragma once

#include <tendon/lockfree/atomics.h>

#include <atomic>
#include <cassert>
#include <cstdint>

namespace tendon {

/// A pointer that one thread uses in its calls while another replaces it and must know when the old
/// object is no longer in use. The calling side pays two plain stores; the replacing side pays for
/// both with a barrier through the whole process.
///
/// Thread safety: Calls by one thread (nested ones too); Exchange() and Get() by other threads, one
/// at a time, never from inside a call, for which they would wait for ever.
///
/// The in-call word counts up when the outermost call begins (odd) and ends (even):
///  - the call makes the word odd, then loads the pointer;
///  - the exchange stores the pointer, then reads the word. The process barrier between stands for
///    a full fence in the call as well: either the exchange sees the call, or the call sees the new
///    pointer;
///  - a word that was odd and has changed belongs to a later call, which has the new pointer. So a
///    thread that calls without a break cannot hold the exchange up.
template <typename T, typename Atomics = StdAtomics>
class GuardedPointer {
 public:
  explicit GuardedPointer(T* initial = nullptr) noexcept : pointer_(initial) {}
  GuardedPointer(const GuardedPointer&) = delete;
  GuardedPointer& operator=(const GuardedPointer&) = delete;

  /// While it lives, what get() gives is not freed.
  class [[nodiscard]] Call {
   public:
    explicit Call(GuardedPointer& guarded) noexcept
        : guarded_(guarded), before_(guarded.in_call_.load(std::memory_order_relaxed)) {  // its own
      guarded_.in_call_.store(before_ | 1U, std::memory_order_release);                   // (B)
      Atomics::CompilerFence();  // with (C) a full fence: odd before the pointer is loaded
      object_ = guarded_.pointer_.load(std::memory_order_acquire);  // pairs with (A)
    }
    ~Call() {
      // Where it was even, the next even one; a nested call leaves it odd. Without a branch.
      guarded_.in_call_.store(before_ + 2 * (~before_ & 1U), std::memory_order_release);  // (B)
    }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

    /// May be null.
    [[nodiscard]] T* get() const noexcept { return object_; }

   private:
    GuardedPointer& guarded_;
    std::uint64_t before_;  // the in-call word
    T* object_;
  };

  /// Makes `next` the object of all further calls, waits until no call uses the old one, and
  /// returns that: the caller may free it. Takes microseconds, and as long as the current call.
  T* Exchange(T* next) noexcept {
    T* const old = Get();
    TryExchange(next, SteadyTime::max());
    return old;
  }

  /// The same, and waits no longer than until `deadline`. False when a call still uses the old
  /// object; it may, as may all objects before it, until an exchange has succeeded.
  bool TryExchange(T* next, SteadyTime deadline) noexcept {
    pointer_.store(next, std::memory_order_release);  // (A) publishes the object
    Atomics::ProcessBarrier();                        // (C)
    const std::uint64_t seen = in_call_.load(std::memory_order_acquire);  // pairs with (B)
    if (seen % 2 == 0) return true;
    for (unsigned looks = 0; in_call_.load(std::memory_order_acquire) == seen; ++looks) {  // (B)
      if (deadline != SteadyTime::max() && Atomics::Now() >= deadline) return false;
      Atomics::Pause(looks);
    }
    return true;
  }

  /// For the side that replaces.
  [[nodiscard]] T* Get() const noexcept { return pointer_.load(std::memory_order_acquire); }

 private:
  typename Atomics::template Atomic<T*> pointer_;
  typename Atomics::template Atomic<std::uint64_t> in_call_{0};  // stored by the calling thread
};

}  // namespace tendon
