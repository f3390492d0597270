#pragma once

#include <tendon/interface/inbox.h>
#include <tendon/lockfree/guarded_pointer.h>
#include <tendon/lockfree/shared_guarded_pointer.h>

#include <cassert>

namespace tendon {

/// A pointer that calling threads use while a manager may replace it. The manager can wait until no
/// caller uses the old object. There may be one calling thread or many.
///
/// Thread safety: the threads that SetCallers() allows call Enter(), also nested. Managers call
/// Exchange() and Get(), one manager at a time, never inside Enter().
template <typename T>
class Gate {
 public:
  /// Sets the threads that may call Enter(). Call it before the first Enter(). `home` is the inbox
  /// of the calling component, or null. If there is one caller, and a thread is bound to `home`,
  /// the caller must be that thread; debug builds check it.
  void SetCallers(CallerThreads callers, const Inbox* home) {
    callers_ = callers;
    home_ = callers == CallerThreads::kOneThread ? home : nullptr;
  }
  [[nodiscard]] CallerThreads callers() const noexcept { return callers_; }

  /// Runs `body(T*)` with the object, which may be null. The object is not freed before `body`
  /// returns.
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
  /// Sets the first object. Only for the thread that calls Enter(), between two of its calls, while
  /// no manager replaces the object.
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
