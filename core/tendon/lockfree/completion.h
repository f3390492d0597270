#pragma once

#include <tendon/base/status.h>
#include <tendon/lockfree/wakeup.h>

#include <atomic>
#include <cstdint>

namespace tendon {

/// What a caller that waits for its call and the server that executes it share. Belongs to a pool:
/// free, pending (not executed yet), started, done or abandoned by its caller.
///
/// Thread safety: any thread may try to take a free one; then one caller, and one server. The last
/// to be done with it frees it: the caller of a done one, the server of an abandoned one.
template <typename Atomics = StdAtomics>
class Completion {
 public:
  enum class Ending {
    kDone,        ///< status() holds; Free() it
    kNotStarted,  ///< and it will not be
    kStarted,     ///< being executed; how it ends will not be known
  };

  // The caller.

  /// From free to pending; false when it is not free.
  bool TryTake() noexcept {
    State expected = kFree;
    if (!state_.compare_exchange_strong(expected, kPending,
                                        std::memory_order_acquire)) {  // pairs with (A)
      return false;
    }
    listener_.store(nullptr, std::memory_order_relaxed);
    return true;
  }
  /// Before it is posted, by a caller that does not sleep in Await(): `listener` is notified once
  /// is_done() holds, and by Interrupt(). It outlives the record.
  void SetListener(Wakeup<Atomics>& listener) noexcept {
    listener_.store(&listener, std::memory_order_release);  // (D)
  }
  [[nodiscard]] bool is_done() const noexcept {
    return state_.load(std::memory_order_acquire) == kDone;  // pairs with (B)
  }
  /// Done with it: what the server has written for this call was read, or it was never posted.
  void Free() noexcept { state_.store(kFree, std::memory_order_release); }  // (A)

  /// Waits until the call was executed, until `interrupted()`, which is notified by Interrupt(), or
  /// until `deadline`. Where it was not executed it belongs to the server.
  template <typename Predicate>
  Ending Await(Predicate interrupted, SteadyTime deadline) {
    wakeup_.WaitUntil(
        [&] { return state_.load(std::memory_order_acquire) == kDone || interrupted(); },  // (B)
        deadline);
    const State before = state_.exchange(kAbandoned, std::memory_order_acq_rel);  // (B), (C)
    if (before == kDone) return Ending::kDone;
    return before == kStarted ? Ending::kStarted : Ending::kNotStarted;
  }
  [[nodiscard]] Status status() const noexcept { return status_; }

  // The server.

  /// Before the call is executed; false when its caller has gone: it is not executed.
  bool Start() noexcept {
    if (state_.exchange(kStarted, std::memory_order_acq_rel) != kAbandoned) return true;  // (C)
    Free();
    return false;
  }
  /// After it. What was written before is seen by the caller that finds it done.
  void Finish(Status status) noexcept {
    // The next caller's, once this one is done.
    Wakeup<Atomics>* const listener = listener_.load(std::memory_order_acquire);  // (D)
    status_ = status;
    if (state_.exchange(kDone, std::memory_order_acq_rel) == kAbandoned) return Free();  // (B), (C)
    wakeup_.Notify();
    if (listener != nullptr) listener->Notify();
  }

  /// Any thread: lets the caller look at `interrupted()`; a listener, if the call was posted
  /// before.
  void Interrupt() noexcept {
    wakeup_.Notify();
    Wakeup<Atomics>* const listener = listener_.load(std::memory_order_acquire);  // (D)
    if (listener != nullptr) listener->Notify();
  }

 private:
  enum State : std::uint32_t { kFree, kPending, kStarted, kDone, kAbandoned };

  // (A) what the last caller has read may be written over
  // (B) what the server has written may be read
  // (C) what a caller that has gone was doing with it is over
  // (D) what the listener is may be used
  typename Atomics::template Atomic<State> state_{kFree};
  Wakeup<Atomics> wakeup_;
  typename Atomics::template Atomic<Wakeup<Atomics>*> listener_{nullptr};
  Status status_ = Status::kDone;
};

}  // namespace tendon
