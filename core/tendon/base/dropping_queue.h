#pragma once

#include <cstddef>
#include <deque>
#include <utility>

namespace tendon {

/// How much may wait at most.
struct QueueBound {
  std::size_t elements = 0;
  std::size_t bytes = 0;
};

/// What waits for a reader who may be slow: bounded in elements and in bytes. An element for which
/// there is no room takes the place of the oldest ones; the newest is always kept, also where it
/// alone is larger than all that may wait.
///
/// Thread safety: one thread at a time.
template <typename T>
class DroppingQueue {
 public:
  explicit DroppingQueue(QueueBound bound) : bound_(bound) {}

  /// Calls `on_dropped(T&)` with each element that makes place, the oldest first.
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

  /// The oldest elements, at least one where there is one, of at most so many bytes otherwise.
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
  /// The next that Take() gives; there must be one.
  [[nodiscard]] T& front() { return waiting_.front().element; }

 private:
  struct Held {
    T element;
    std::size_t bytes = 0;
  };

  void RemoveFront() {
    bytes_ -= waiting_.front().bytes;
    waiting_.pop_front();
  }

  const QueueBound bound_;
  std::deque<Held> waiting_;
  std::size_t bytes_ = 0;
};

}  // namespace tendon
