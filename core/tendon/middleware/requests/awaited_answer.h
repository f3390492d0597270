#pragma once

#include <tendon/middleware/requests/pending_requests.h>

#include <cstdint>
#include <optional>
#include <utility>

namespace tendon {

/// A request whose caller waits for the answer itself: instead of a handler, which would be
/// allocated for each. Of one thread; not for longer than the PendingRequests.
class AwaitedAnswer {
 public:
  explicit AwaitedAnswer(PendingRequests& requests)
      : requests_(requests), place_(requests.AddAwaited()) {
    if (place_ != nullptr) number_ = place_->request;
  }
  AwaitedAnswer(const AwaitedAnswer&) = delete;
  AwaitedAnswer& operator=(const AwaitedAnswer&) = delete;
  ~AwaitedAnswer() { (void)Leave(); }

  /// That of the request; 0 where none are sent any more.
  [[nodiscard]] std::uint64_t number() const { return number_; }

  /// What it was finished with; nothing when `deadline` has passed before. Once: what comes then
  /// is late.
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
