#pragma once

#include <cstddef>
#include <deque>
#include <utility>

namespace tendon {

/// The largest number of elements and of bytes that a queue holds.
struct QueueBound {
  std::size_t elements = 0;
  std::size_t bytes = 0;
};

/// A queue for a slow reader, bounded in elements and in bytes. If there is no room for a new
/// element, the oldest ones are dropped. The newest one is always kept, even if it alone is larger
/// than the bound.
///
/// Thread safety: one thread at a time.
template <typename T>
class DroppingQueue {
 public:
  explicit DroppingQueue(QueueBound bound) : bound_(bound) {}

  /// Calls `on_dropped(T&)` for each dropped element, oldest first.
  template <typename OnDropped>
  void Push(T element, std::size_t bytes, OnDropped&& on_dropped) {
    while (!waiting_.empty() &&
           (waiting_.size() >= bound_.elements || bytes_ + bytes > bound_.bytes)) {
      on_dropped(waiting_.front().element);
      RemoveFront();
    }
    waiting_.push_back({std::move(element), bytes});
    bytes_ += bytes;
  }

  /// Removes and returns the oldest elements: at most `most_bytes` in total, but at least one
  /// element if the queue is not empty.
  [[nodiscard]] std::deque<T> Take(std::size_t most_bytes) {
    std::deque<T> taken;
    std::size_t size = 0;
    while (!waiting_.empty() && (taken.empty() || size + waiting_.front().bytes <= most_bytes)) {
      size += waiting_.front().bytes;
      taken.push_back(std::move(waiting_.front().element));
      RemoveFront();
    }
    return taken;
  }

  [[nodiscard]] bool is_empty() const { return waiting_.empty(); }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  /// Returns the next element that Take() returns. The queue must not be empty.
  [[nodiscard]] T& front() { return waiting_.front().element; }

 private:
  struct Item {
    T element;
    std::size_t bytes = 0;
  };

  void RemoveFront() {
    bytes_ -= waiting_.front().bytes;
    waiting_.pop_front();
  }

  const QueueBound bound_;
  std::deque<Item> waiting_;
  std::size_t bytes_ = 0;
};

}  // namespace tendon
