#include <tendon/gcm/client/source_clock.h>

#include <tendon/process/ask.h>
#include <tendon/proxy/connection_messages.h>

#include <algorithm>
#include <utility>

namespace tendon::client {

SourceClock::SourceClock(std::shared_ptr<Worker> timer, std::shared_ptr<Channel> channel,
                         std::chrono::milliseconds timeout)
    : timer_(std::move(timer)), channel_(std::move(channel)), timeout_(timeout) {}

void SourceClock::WhenKnown(Handler known) {
  std::unique_lock lock(mutex_);
  if (!is_known_) {
    waiting_.push_back(std::move(known));
    if (waiting_.size() > 1) return;
    lock.unlock();
    return Ask();
  }
  lock.unlock();
  known(shared_from_this());
}

/// Sends a measurement. The pending request keeps this object alive until the reply arrives. After
/// that, only the users of this clock keep it alive.
void SourceClock::Ask() {
  tendon::Ask<message::Pong>(
      *timer_, channel_, message::kPing, None{}, timeout_,
      [self = shared_from_this(), sent = SteadyClock().Now()](const Result<message::Pong>& reply) {
        std::vector<Handler> waiting;
        {
          const std::scoped_lock lock(self->mutex_);
          if (reply) {
            self->is_known_ = true;
            self->offset_.Add(sent, SteadyTime(std::chrono::nanoseconds(reply->time)),
                              SteadyClock().Now());
          }
          waiting.swap(self->waiting_);
        }
        for (const Handler& known : waiting) reply ? known(self) : known(reply.error());
        self->AskLater();
      },
      kOwnLane);
}

void SourceClock::AskLater() {
  constexpr std::chrono::milliseconds kBetweenQuestions(500);
  {
    const std::scoped_lock lock(mutex_);
    if (!is_known_ || !channel_->is_open()) return;
  }
  timer_->PostAfter(kBetweenQuestions, [weak = weak_from_this()] {
    if (const auto self = weak.lock()) self->Ask();
  });
}

EventTime SourceClock::ToLocal(SteadyTime there) const {
  const SteadyTime now = SteadyClock().Now();
  const std::scoped_lock lock(mutex_);
  const ClockOffset::Estimate estimate = offset_.At(now);
  if (estimate.uncertainty == ClockOffset::kUnknown) return {.raised = now};
  const SteadyTime raised = ClockOffset::Sensible(there) - estimate.offset;
  return {.raised = std::min(raised, now), .uncertainty = estimate.uncertainty};
}

}  // namespace tendon::client
