#pragma once

#include <tendon/base/status.h>
#include <tendon/lockfree/wakeup.h>

#include <atomic>
#include <cstdint>

namespace tendon {

/// The record that a waiting caller shares with the server of its call. It belongs to a pool. Its
/// states are: free, pending (not executed yet), started, done, abandoned by its caller.
///
/// Thread safety: any thread may try to take a free record; then one caller and one server use it.
/// The side that finishes last frees it: the caller frees a done record, the server an abandoned
/// one.
template <typename Atomics = StdAtomics>
class Completion {
 public:
  enum class Ending {
    kDone,        ///< status() is valid; call Free()
    kNotStarted,  ///< the call will never be executed
    kStarted,     ///< the call is being executed; the outcome stays unknown
  };

  // For the caller.

  /// Changes the state from free to pending. Returns false if the state is not free.
  bool TryTake() noexcept {
    State expected = kFree;
    if (!state_.compare_exchange_strong(expected, kPending,
                                        std::memory_order_acquire)) {  // pairs with (A)
      return false;
    }
    listener_.store(nullptr, std::memory_order_relaxed);
    return true;
  }
  /// Called before the call is posted, by a caller that does not sleep in Await(). `listener`,
  /// which must outlive this record, is notified when the call is done, and by Interrupt().
  void SetListener(Wakeup<Atomics>& listener) noexcept {
    listener_.store(&listener, std::memory_order_release);  // (D)
  }
  [[nodiscard]] bool is_done() const noexcept {
    return state_.load(std::memory_order_acquire) == kDone;  // pairs with (B)
  }
  /// Frees the record. Called when the caller has read the server's results, or if it has not
  /// posted the call.
  void Free() noexcept { state_.store(kFree, std::memory_order_release); }  // (A)

  /// Waits until the call is executed, until `deadline`, or until `interrupted()` returns true.
  /// Interrupt() makes this function check `interrupted()` again. If the call was not executed, the
  /// record now belongs to the server.
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

  // For the server.

  /// Called before the execution. Returns false if the caller has stopped waiting; then the server
  /// must not execute the call.
  bool Start() noexcept {
    if (state_.exchange(kStarted, std::memory_order_acq_rel) != kAbandoned) return true;  // (C)
    Free();
    return false;
  }
  /// Called after the execution. A caller that sees the state "done" also sees everything that the
  /// server wrote before this call.
  void Finish(Status status) noexcept {
    // The listener is read before the exchange, because after the state has become done, the next
    // caller may already have set its own listener.
    Wakeup<Atomics>* const listener = listener_.load(std::memory_order_acquire);  // (D)
    status_ = status;
    if (state_.exchange(kDone, std::memory_order_acq_rel) == kAbandoned) return Free();  // (B), (C)
    wakeup_.Notify();
    if (listener != nullptr) listener->Notify();
  }

  /// Makes the caller check `interrupted()`. Also notifies the listener, if the call has one. Any
  /// thread.
  void Interrupt() noexcept {
    wakeup_.Notify();
    Wakeup<Atomics>* const listener = listener_.load(std::memory_order_acquire);  // (D)
    if (listener != nullptr) listener->Notify();
  }

 private:
  enum State : std::uint32_t { kFree, kPending, kStarted, kDone, kAbandoned };

  // (A) the next caller may overwrite the data that the last caller has read
  // (B) the caller may read the data that the server has written
  // (C) the server may free the record: its caller no longer uses it
  // (D) the server may use the listener
  typename Atomics::template Atomic<State> state_{kFree};
  Wakeup<Atomics> wakeup_;
  typename Atomics::template Atomic<Wakeup<Atomics>*> listener_{nullptr};
  Status status_ = Status::kDone;
};

}  // namespace tendon
