#include <tendon/gcm/client/event_listener.h>

#include <algorithm>
#include <utility>

namespace tendon::client {

bool EventListener::Try(std::uint32_t attempt) {
  const std::scoped_lock lock(mutex_);
  if (!sink_ || attempt_ != 0) return false;
  attempt_ = attempt;
  return true;
}

bool EventListener::OnSubscribed(std::uint32_t attempt, Subscription subscription,
                                 const std::vector<MemberDescription>& events) {
  const std::scoped_lock lock(mutex_);
  if (!sink_ || attempt_ != attempt) return false;
  subscription_ = std::move(subscription);
  lost_.assign(wanted_.size(), 0);
  interruption_.reset();
  sink_->OnListening(events);
  return true;
}

bool EventListener::Fail(std::uint32_t attempt, const Error& reason) {
  const std::scoped_lock lock(mutex_);
  if (attempt_ != attempt) return false;
  attempt_ = 0;
  subscription_ = {};
  if (!sink_) return false;
  if (interruption_ != reason) sink_->OnStale(reason);
  interruption_ = reason;
  return true;
}

void EventListener::End() {
  const std::scoped_lock lock(mutex_);
  sink_.reset();
  if (subscription_.channel) {
    (void)subscription_.channel->Notify(message::kCloseInterface, subscription_.handle, Bytes());
  }
  subscription_ = {};
}

void EventListener::Raise(std::uint32_t attempt, std::size_t event,
                          std::span<const std::byte> value, SteadyTime there) {
  const std::scoped_lock lock(mutex_);
  if (!subscription_.channel || attempt_ != attempt || event >= wanted_.size()) return;
  sink_->OnEvent(event, value, subscription_.clock->ToLocal(there));
}

void EventListener::OnLost(std::uint32_t attempt, const message::EventsLost& events) {
  const std::scoped_lock lock(mutex_);
  if (!subscription_.channel || attempt_ != attempt) return;
  for (std::size_t i = 0; i < std::min(lost_.size(), events.lost.size()); ++i) {
    if (events.lost[i] <= lost_[i]) continue;
    sink_->OnEventsLost(i, events.lost[i] - std::exchange(lost_[i], events.lost[i]));
  }
}

}  // namespace tendon::client
