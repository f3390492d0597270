#pragma once

#include <tendon/base/dropping_queue.h>

#include <cstddef>
#include <deque>
#include <utility>

namespace console {

/// The most that a verb keeps for its printing thread.
inline constexpr tendon::QueueBound kMostWaiting = {.elements = 100000,
                                                    .bytes = std::size_t{32} << 20U};
/// The most bytes to take at a time, which a single larger element may exceed.
inline constexpr std::size_t kMostTaken = std::size_t{1} << 20U;

/// Keeps elements for the printing thread, and counts the losses between them. When it is full, the
/// oldest elements are dropped and count as lost. `Lost` has `+=`, and counts nothing at first.
///
/// Thread safety: one thread at a time.
template <typename T, typename Lost>
class InboxQueue {
 public:
  struct Entry {
    T element;
    Lost lost_before{};  ///< between the previous element and this one
  };

  explicit InboxQueue(tendon::QueueBound bound = kMostWaiting) : queue_(bound) {}

  /// `loss_of(const T&)` is the loss if an element is dropped.
  template <typename LossOf>
  void Push(T element, std::size_t bytes, LossOf&& loss_of) {
    Lost gap{};
    queue_.Push({std::move(element), std::exchange(lost_, Lost{})}, bytes,
                [&](const Entry& oldest) {
                  gap += oldest.lost_before;
                  gap += loss_of(oldest.element);
                });
    queue_.front().lost_before += gap;
  }
  /// Adds a loss after the newest element.
  void AddLost(const Lost& lost) { lost_ += lost; }

  /// Removes and returns the oldest elements, at most kMostTaken.
  [[nodiscard]] std::deque<Entry> Take() { return queue_.Take(kMostTaken); }
  /// Removes and returns the losses after the last element; none while elements wait.
  [[nodiscard]] Lost TakeLost() {
    return queue_.is_empty() ? std::exchange(lost_, Lost{}) : Lost{};
  }
  [[nodiscard]] bool is_empty() const { return queue_.is_empty(); }

 private:
  tendon::DroppingQueue<Entry> queue_;
  Lost lost_{};  // after the newest element
};

}  // namespace console
