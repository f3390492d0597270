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
    explicit Call(GuardedPointer& guarded) noexcept : guarded_(guarded) {
      if (guarded_.depth_++ == 0) {
        guarded_.in_call_.store(++guarded_.calls_, std::memory_order_release);  // (B)
      }
      Atomics::CompilerFence();  // with (C) a full fence: odd before the pointer is loaded
      object_ = guarded_.pointer_.load(std::memory_order_acquire);  // pairs with (A)
    }
    ~Call() {
      if (--guarded_.depth_ > 0) return;
      guarded_.in_call_.store(++guarded_.calls_, std::memory_order_release);  // (B) done with it
    }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

    /// May be null.
    [[nodiscard]] T* get() const noexcept { return object_; }

   private:
    GuardedPointer& guarded_;
    T* object_;
  };

  /// Makes `next` the object of all further calls, waits until no call uses the old one, and
  /// returns that: the caller may free it. Takes microseconds, and as long as the current call.
  T* Exchange(T* next) noexcept {
    T* const old = pointer_.load(std::memory_order_relaxed);
    pointer_.store(next, std::memory_order_release);  // (A) publishes the object
    Atomics::ProcessBarrier();                        // (C)
    const std::uint64_t seen = in_call_.load(std::memory_order_acquire);  // pairs with (B)
    if (seen % 2 == 0) return old;
    for (unsigned looks = 0; in_call_.load(std::memory_order_acquire) == seen; ++looks) {  // (B)
      Atomics::Pause(looks);
    }
    return old;
  }

  /// For the side that replaces.
  [[nodiscard]] T* Get() const noexcept { return pointer_.load(std::memory_order_acquire); }

 private:
  typename Atomics::template Atomic<T*> pointer_;
  typename Atomics::template Atomic<std::uint64_t> in_call_{0};
  std::uint64_t calls_ = 0;  // of the calling thread: what in_call_ holds
  unsigned depth_ = 0;       // of the calling thread
};

}  // namespace tendon
