#pragma once

#include <tendon/lockfree/wakeup.h>

#include <atomic>

namespace tendon {

/// Shows that a queue may have items, so that the consumer need not check empty queues: the flags
/// of many queues are adjacent in memory, one byte each.
///
/// Thread safety: any thread may raise the flag after it has published an item; one thread consumes
/// the items.
///
/// As in Wakeup, no item is missed: the producer publishes, then reads the flag; the consumer
/// lowers the flag, then looks for items. With a full fence between the two steps on both sides, at
/// least one side sees what the other side has stored.
///
/// A producer usually finds the flag already raised. Then it writes only to the queue, and to
/// nothing else that the consumer reads. Another producer may have raised the flag a moment before;
/// then (B) orders this producer's read of the sleeper's flag after that store, so this producer
/// can wake the sleeper itself. (The simulator does not model this.)
template <typename Atomics = StdAtomics>
class ReadyFlag {
 public:
  /// Raises the flag. Also wakes the consumer if it sleeps on `wakeup`, which may be null.
  void Raise(Wakeup<Atomics>* wakeup) noexcept {
    Atomics::Fence(std::memory_order_seq_cst);     // (A) published before the flags are read
    if (!up_.load(std::memory_order_acquire)) {    // pairs with (B)
      up_.store(true, std::memory_order_release);  // (B) raised, also for other producers
      Atomics::Fence(std::memory_order_seq_cst);   // raised before the sleeper's flag is read
    }
    if (wakeup != nullptr) wakeup->NotifyAfterFence();
  }

  enum class IfEmpty { kLeaveUp, kLower };

  /// Consumer: calls `has_items()` if the flag is raised, and returns its result. kLower lowers the
  /// flag if there are no items. A consumer should not do this at every check, because fast
  /// producers would have to raise the flag again each time.
  template <typename Predicate>
  bool IsReady(Predicate has_items, IfEmpty if_empty) noexcept {
    if (!up_.load(std::memory_order_relaxed)) return false;  // orders nothing
    if (has_items()) return true;
    if (if_empty == IfEmpty::kLeaveUp) return false;
    up_.store(false, std::memory_order_relaxed);
    Atomics::Fence(std::memory_order_seq_cst);  // pairs with (A): lowered before the check
    if (!has_items()) return false;
    up_.store(true, std::memory_order_release);  // (B)
    return true;
  }

 private:
  typename Atomics::template Atomic<bool> up_{false};
};

}  // namespace tendon
