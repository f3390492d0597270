#pragma once

#include <tendon/interface/inbox.h>
#include <tendon/lockfree/guarded_pointer.h>
#include <tendon/lockfree/shared_guarded_pointer.h>

#include <cassert>

namespace tendon {

/// A pointer that callers use while a manager replaces it. The manager can wait until no caller
/// uses the old object. For one calling thread or for many.
///
/// Thread safety: the threads that SetCallers() allows call Enter(), also nested. Managers call
/// Exchange() and Get(), one manager at a time, never inside Enter().
template <typename T>
class Gate {
 public:
  /// Sets the threads that may call Enter(). Call it before the first Enter(). `home` is the inbox
  /// of the calling component, or null. If a thread is bound to `home`, a single caller must be
  /// that thread; debug builds check it.
  void SetCallers(CallerThreads callers, const Inbox* home) {
    callers_ = callers;
    home_ = callers == CallerThreads::kOneThread ? home : nullptr;
  }
  [[nodiscard]] CallerThreads callers() const noexcept { return callers_; }

  /// Runs `body(T*)` with the object, which may be null and is not freed meanwhile.
  template <typename Body>
  auto Enter(Body body) {
    if (callers_ == CallerThreads::kManyThreads) {
      const typename SharedGuardedPointer<T>::Call call(many_);
      return body(call.get());
    }
    assert((home_ == nullptr || !home_->IsForeignThread()) &&
           "a task's functions and events belong to its own thread");
    const typename GuardedPointer<T>::Call call(one_);
    return body(call.get());
  }

  /// Replaces the object and waits until no call uses the old object. Then the old object may be
  /// freed.
  void Exchange(T* next) noexcept {
    if (callers_ == CallerThreads::kManyThreads) {
      many_.Exchange(next);
    } else {
      one_.Exchange(next);
    }
  }
  /// Sets the first object, for all further calls. Called by the thread that calls Enter(), between
  /// two of its calls, while no manager replaces the object.
  void SetByCaller(T* object) noexcept {
    if (callers_ == CallerThreads::kManyThreads) {
      many_.Exchange(object);
    } else {
      one_.SetByCaller(object);
    }
  }
  /// Returns the current object. Only for the threads that replace it.
  [[nodiscard]] T* Get() const noexcept {
    return callers_ == CallerThreads::kManyThreads ? many_.Get() : one_.Get();
  }

 private:
  CallerThreads callers_ = CallerThreads::kOneThread;
  const Inbox* home_ = nullptr;
  GuardedPointer<T> one_;
  SharedGuardedPointer<T> many_;
};

}  // namespace tendon
