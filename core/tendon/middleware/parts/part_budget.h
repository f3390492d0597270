#pragma once

#include <cstddef>
#include <mutex>

namespace tendon {

/// How many bytes may be kept of messages that have begun to arrive and are not whole, on all links
/// together. Thread-safe.
class PartBudget {
 public:
  explicit PartBudget(std::size_t most) : left_(most) {}
  PartBudget(const PartBudget&) = delete;
  PartBudget& operator=(const PartBudget&) = delete;

  /// False, and nothing is taken, where there are no more so many.
  bool Take(std::size_t size) {
    const std::scoped_lock lock(mutex_);
    if (size > left_) return false;
    left_ -= size;
    return true;
  }
  void GiveBack(std::size_t size) {
    const std::scoped_lock lock(mutex_);
    left_ += size;
  }

  static constexpr std::size_t kOfProcess = std::size_t{512} << 20U;
  static PartBudget& OfProcess() {
    static PartBudget& budget = *new PartBudget(kOfProcess);  // for ever: threads may end after all
    return budget;
  }

 private:
  std::mutex mutex_;
  std::size_t left_;
};

}  // namespace tendon
