#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>

namespace tendon {

/// Limits how many requests of one peer wait for a thread, because waiting requests need memory and
/// a peer may send faster than it is served. Thread-safe.
class RequestQuota : public std::enable_shared_from_this<RequestQuota> {
 public:
  /// Four times the subscriptions that a viewer may have.
  static constexpr std::size_t kMostTasks = 8192;
  /// Bytes of messages; also the limit of a single one.
  static constexpr std::size_t kMostBytes = std::size_t{8} << 20U;

  /// Counts one waiting request while it lives.
  class Place {
   public:
    Place(std::shared_ptr<RequestQuota> backlog, std::size_t bytes)
        : backlog_(std::move(backlog)), bytes_(bytes) {}
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;
    ~Place() { backlog_->Leave(bytes_); }

   private:
    const std::shared_ptr<RequestQuota> backlog_;
    const std::size_t bytes_;
  };

  /// Null if the request would exceed the limits.
  [[nodiscard]] std::shared_ptr<Place> Enter(std::size_t bytes);

 private:
  void Leave(std::size_t bytes);

  std::mutex mutex_;
  std::size_t tasks_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace tendon
