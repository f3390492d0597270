#pragma once

#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace tendon::test {

/// A list of values in the order in which they were added.
///
/// Thread safety: all functions, any thread.
template <typename T>
class Record {
 public:
  /// Returns the place of the value, for Replace().
  std::size_t Add(T value) {
    const std::scoped_lock lock(mutex_);
    values_.push_back(std::move(value));
    return values_.size() - 1;
  }
  /// Replaces a value. Use it for a value that is not known yet when its place is added.
  void Replace(std::size_t place, T value) {
    const std::scoped_lock lock(mutex_);
    values_.at(place) = std::move(value);
  }
  /// Returns all values and removes them.
  std::vector<T> Take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(values_, {});
  }
  [[nodiscard]] std::vector<T> values() const {
    const std::scoped_lock lock(mutex_);
    return values_;
  }
  [[nodiscard]] std::size_t size() const {
    const std::scoped_lock lock(mutex_);
    return values_.size();
  }

 private:
  mutable std::mutex mutex_;
  std::vector<T> values_;
};

}  // namespace tendon::test
