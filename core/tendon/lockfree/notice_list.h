#pragma once

#include <tendon/lockfree/atomics.h>

#include <atomic>
#include <list>
#include <utility>

namespace tendon {

/// An unbounded list of notices from one thread to another. The sender allocates and frees; the
/// receiver takes all notices without a lock, an allocation or a system call. After R. K. Treiber,
/// "Systems Programming: Coping with Parallelism" (1986); taking the whole stack avoids the ABA
/// problem.
///
/// Thread safety: one thread at a time may call Send(), one other thread Take(). Take() is
/// wait-free; it costs one load if there is no notice.
template <typename T, typename Atomics = StdAtomics>
class NoticeList {
 public:
  NoticeList() = default;
  NoticeList(const NoticeList&) = delete;
  NoticeList& operator=(const NoticeList&) = delete;

  /// Adds a notice. Also frees the notices that the receiver has taken.
  void Send(T notice) {
    notices_.remove_if([](const Node& node) {
      return node.is_taken.load(std::memory_order_acquire);  // pairs with (B)
    });
    Node& node = notices_.emplace_back(std::move(notice));
    node.next = newest_.load(std::memory_order_relaxed);
    while (!newest_.compare_exchange_strong(node.next, &node, std::memory_order_release)) {  // (A)
    }
  }

  /// True if a notice that satisfies `predicate(const T&)` still waits for the receiver. Only for
  /// the sending thread.
  template <typename Predicate>
  [[nodiscard]] bool HasUnread(Predicate predicate) const {
    for (const Node& node : notices_) {
      if (!node.is_taken.load(std::memory_order_acquire) && predicate(node.value)) return true;
    }
    return false;
  }

  /// Calls `action(const T&)` for each notice, oldest first.
  template <typename Action>
  void Take(Action action) {
    if (newest_.load(std::memory_order_relaxed) == nullptr) return;
    Node* node = newest_.exchange(nullptr, std::memory_order_acquire);  // pairs with (A)
    Node* oldest = nullptr;
    while (node != nullptr) {
      Node* const next = std::exchange(node->next, oldest);
      oldest = std::exchange(node, next);
    }
    while (oldest != nullptr) {
      Node* const next = oldest->next;
      action(std::as_const(oldest->value));
      oldest->is_taken.store(true, std::memory_order_release);  // (B) the node may be freed
      oldest = next;
    }
  }

 private:
  struct Node {
    explicit Node(T&& notice) : value(std::move(notice)) {}

    T value;
    Node* next = nullptr;
    typename Atomics::template Atomic<bool> is_taken{false};
  };

  std::list<Node> notices_;  // used only by the sender
  typename Atomics::template Atomic<Node*> newest_{nullptr};
};

}  // namespace tendon
