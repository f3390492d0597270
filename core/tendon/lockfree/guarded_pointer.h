#pragma once

#include <tendon/lockfree/atomics.h>

#include <atomic>
#include <cstdint>

namespace tendon {

/// A pointer that one thread uses in its calls. Another thread can replace the pointer, and learns
/// when the old object is no longer in use. A call costs three plain stores; a replacement costs a
/// memory barrier in the whole process.
///
/// Thread safety: one thread makes Calls, which may be nested. Other threads use Exchange() and
/// Get(), one thread at a time. They must not do so inside a Call, because they would wait forever.
///
/// The in-call word identifies the object that the thread uses:
/// - A call stores that it uses some object, then loads the pointer, then stores which object. If
///   nested calls use different objects, the word stays at "some object".
/// - The exchange stores the pointer, then reads the word. The process barrier in between is a full
///   fence in the call as well: either the exchange sees the call, or the call sees the new
///   pointer.
/// - A user of the new object never delays the exchange, even if it runs for a long time.
///   Therefore, neither a thread that calls without a break nor a call that waits for something
///   delays it.
template <typename T, typename Atomics = StdAtomics>
class GuardedPointer {
 public:
  explicit GuardedPointer(T* initial = nullptr) noexcept : pointer_(initial) {}
  GuardedPointer(const GuardedPointer&) = delete;
  GuardedPointer& operator=(const GuardedPointer&) = delete;

  /// While this object exists, the object of get() is not freed.
  class [[nodiscard]] Call {
   public:
    explicit Call(GuardedPointer& guarded) noexcept
        // Only this thread writes in_call_.
        : guarded_(guarded), before_(guarded.in_call_.load(std::memory_order_relaxed)) {
      guarded_.in_call_.store(kSomeObject, std::memory_order_release);
      Atomics::CompilerFence();  // with (C) a full fence between store and load
      object_ = guarded_.pointer_.load(std::memory_order_acquire);  // pairs with (A)
      const std::uintptr_t word = WordOf(object_);
      const bool is_only_one = before_ == kNoObject || before_ == word;
      guarded_.in_call_.store(is_only_one ? word : kSomeObject, std::memory_order_release);  // (B)
    }
    ~Call() { guarded_.in_call_.store(before_, std::memory_order_release); }  // (B)
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

    /// May be null.
    [[nodiscard]] T* get() const noexcept { return object_; }

   private:
    GuardedPointer& guarded_;
    std::uintptr_t before_;  // the in-call word before this call
    T* object_;
  };

  /// Makes `next` the object of all further calls, waits until no call uses the old object, and
  /// returns it; the caller may free it. Takes microseconds, plus the rest of a running call that
  /// uses the old object.
  T* Exchange(T* next) noexcept {
    T* const old = Get();
    TryExchange(next, SteadyTime::max());
    return old;
  }

  /// Like Exchange(), but waits at most until `deadline`. Returns false if a call still uses the
  /// old object. Then the old object and all earlier objects may be in use until an exchange
  /// succeeds.
  bool TryExchange(T* next, SteadyTime deadline) noexcept {
    pointer_.store(next, std::memory_order_release);  // (A) publishes the object
    Atomics::ProcessBarrier();                        // (C)
    for (unsigned looks = 0;; ++looks) {
      const std::uintptr_t word = in_call_.load(std::memory_order_acquire);  // pairs with (B)
      if (word == kNoObject || word == WordOf(next)) return true;
      if (deadline != SteadyTime::max() && Atomics::Now() >= deadline) return false;
      Atomics::Pause(looks);
    }
  }

  /// Sets the first object without an exchange. Only for the calling thread, between two of its
  /// calls, while the pointer is null and no other thread calls Exchange(). Costs one store.
  void SetByCaller(T* object) noexcept {
    pointer_.store(object, std::memory_order_release);  // (A)
  }

  /// Returns the current object. Only for the threads that call Exchange().
  [[nodiscard]] T* Get() const noexcept { return pointer_.load(std::memory_order_acquire); }

 private:
  // Objects are aligned, so the word of an object never equals these values.
  static constexpr std::uintptr_t kNoObject = 0;
  static constexpr std::uintptr_t kSomeObject = 1;  // an object that is not known yet, or several

  static std::uintptr_t WordOf(T* object) noexcept {
    static_assert(alignof(T) >= 4);
    return reinterpret_cast<std::uintptr_t>(object) | 2U;
  }

  typename Atomics::template Atomic<T*> pointer_;
  typename Atomics::template Atomic<std::uintptr_t> in_call_{kNoObject};  // stored by the callers
};

}  // namespace tendon
