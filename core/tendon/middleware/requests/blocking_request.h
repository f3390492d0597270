#pragma once

#include <tendon/middleware/requests/pending_requests.h>

#include <cstdint>
#include <optional>
#include <utility>

namespace tendon {

/// A request whose caller waits for the answer. Needs no handler, and so no allocation for each
/// request. Used by one thread; must not outlive the PendingRequests.
class BlockingRequest {
 public:
  explicit BlockingRequest(PendingRequests& requests)
      : requests_(requests), place_(requests.AddAwaited()) {
    if (place_ != nullptr) number_ = place_->request;
  }
  BlockingRequest(const BlockingRequest&) = delete;
  BlockingRequest& operator=(const BlockingRequest&) = delete;
  ~BlockingRequest() { (void)Leave(); }

  /// The number of the request; 0 if no more requests can be sent.
  [[nodiscard]] std::uint64_t number() const { return number_; }

  /// Returns the outcome, or no value once `deadline` has passed. Call it once: a later answer
  /// counts as late.
  std::optional<Result<Answer>> WaitUntil(SteadyTime deadline) {
    if (place_ == nullptr) return std::nullopt;
    place_->wakeup.WaitUntil([this] { return place_->has_ended.Get(); }, deadline);
    return Leave();
  }

 private:
  std::optional<Result<Answer>> Leave() {
    PendingRequests::Place* const place = std::exchange(place_, nullptr);
    return place == nullptr ? std::nullopt : requests_.Leave(*place);
  }

  PendingRequests& requests_;
  PendingRequests::Place* place_;
  std::uint64_t number_ = 0;
};

}  // namespace tendon
