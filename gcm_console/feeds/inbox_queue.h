#pragma once

#include <tendon/base/dropping_queue.h>

#include <cstddef>
#include <deque>
#include <utility>

namespace console {

/// The maximum that a verb stores for its printing thread.
inline constexpr tendon::QueueBound kMaxWaiting = {.elements = 100000,
                                                   .bytes = std::size_t{32} << 20U};
/// The maximum number of bytes to take at a time. A single larger element is taken as well.
inline constexpr std::size_t kMaxTaken = std::size_t{1} << 20U;

/// Stores elements for the printing thread, and the losses between them. When the queue is full,
/// the oldest elements are dropped and count as lost. `Lost` must have `+=`, and must be zero if
/// created without arguments.
///
/// Thread safety: use it in one thread at a time.
template <typename T, typename Lost>
class InboxQueue {
 public:
  struct Entry {
    T element;
    Lost lost_before{};  ///< losses between the previous element and this one
  };

  explicit InboxQueue(tendon::QueueBound bound = kMaxWaiting) : queue_(bound) {}

  /// Adds an element of this size. `loss_of(const T&)` returns the loss if an element is dropped.
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
  /// Adds a loss that occurred after the newest element.
  void AddLost(const Lost& lost) { lost_ += lost; }

  /// Removes and returns the oldest elements, at most kMaxTaken bytes.
  [[nodiscard]] std::deque<Entry> Take() { return queue_.Take(kMaxTaken); }
  /// Removes and returns the losses after the last element. Returns none while there are elements.
  [[nodiscard]] Lost TakeLost() {
    return queue_.is_empty() ? std::exchange(lost_, Lost{}) : Lost{};
  }
  [[nodiscard]] bool is_empty() const { return queue_.is_empty(); }

 private:
  tendon::DroppingQueue<Entry> queue_;
  Lost lost_{};  // losses after the newest element
};

}  // namespace console
