#pragma once

#include <tendon/interface/inbox.h>
#include <tendon/lockfree/guarded_pointer.h>
#include <tendon/lockfree/shared_guarded_pointer.h>

#include <cassert>

namespace tendon {

/// A pointer that callers use while a manager replaces it and must know when the old object is no
/// longer in use; made for one calling thread or for many.
///
/// Thread safety: Enter() by whom SetCallers() has allowed, nested too; Exchange() and Get() by
/// managers, one at a time, never from inside a call.
template <typename T>
class Gate {
 public:
  /// Before the first call. `home` is the inbox of the component that calls, or null: once a thread
  /// is bound to it, a lone caller is that thread, which debug builds check.
  void SetCallers(Callers callers, const Inbox* home) {
    callers_ = callers;
    home_ = callers == Callers::kOneThread ? home : nullptr;
  }
  [[nodiscard]] Callers callers() const noexcept { return callers_; }

  /// `body(T*)` with the object, which may be null and is not freed meanwhile.
  template <typename Body>
  auto Enter(Body body) {
    if (callers_ == Callers::kManyThreads) {
      const typename SharedGuardedPointer<T>::Call call(many_);
      return body(call.get());
    }
    assert((home_ == nullptr || !home_->IsForeignThread()) &&
           "a task's functions and events belong to its own thread");
    const typename GuardedPointer<T>::Call call(one_);
    return body(call.get());
  }

  /// Waits until no call uses the old object; the caller may free it.
  void Exchange(T* next) noexcept {
    if (callers_ == Callers::kManyThreads) {
      many_.Exchange(next);
    } else {
      one_.Exchange(next);
    }
  }
  /// Makes the first object that of all further calls: in the calling thread, between two of its
  /// calls, while nobody replaces it.
  void SetByCaller(T* object) noexcept {
    if (callers_ == Callers::kManyThreads) {
      many_.Exchange(object);
    } else {
      one_.SetByCaller(object);
    }
  }
  /// For the side that replaces.
  [[nodiscard]] T* Get() const noexcept {
    return callers_ == Callers::kManyThreads ? many_.Get() : one_.Get();
  }

 private:
  Callers callers_ = Callers::kOneThread;
  const Inbox* home_ = nullptr;
  GuardedPointer<T> one_;
  SharedGuardedPointer<T> many_;
};

}  // namespace tendon
