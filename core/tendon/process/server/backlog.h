#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>

namespace tendon {

/// What one peer has asked of a thread that has not come to it yet: a peer may ask faster than it
/// is served, and what it has asked takes memory. Thread-safe.
class Backlog : public std::enable_shared_from_this<Backlog> {
 public:
  /// Four times what a viewer may have of subscriptions.
  static constexpr std::size_t kMostTasks = 8192;
  /// Of messages; one alone may not be larger either.
  static constexpr std::size_t kMostBytes = std::size_t{8} << 20U;

  /// While it lives, something waits.
  class Place {
   public:
    Place(std::shared_ptr<Backlog> backlog, std::size_t bytes)
        : backlog_(std::move(backlog)), bytes_(bytes) {}
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;
    ~Place() { backlog_->Leave(bytes_); }

   private:
    const std::shared_ptr<Backlog> backlog_;
    const std::size_t bytes_;
  };

  /// Null where that would be too much.
  [[nodiscard]] std::shared_ptr<Place> Enter(std::size_t bytes);

 private:
  void Leave(std::size_t bytes);

  std::mutex mutex_;
  std::size_t tasks_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace tendon
