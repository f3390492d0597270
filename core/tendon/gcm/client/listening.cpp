#include <tendon/gcm/client/listening.h>

#include <algorithm>
#include <utility>

namespace tendon::client {

bool Listening::Try(std::uint32_t attempt) {
  const std::scoped_lock lock(mutex_);
  if (!sink_ || attempt_ != 0) return false;
  attempt_ = attempt;
  return true;
}

bool Listening::Stand(std::uint32_t attempt, std::shared_ptr<Channel> channel, std::uint32_t handle,
                      const std::vector<MemberDescription>& events) {
  const std::scoped_lock lock(mutex_);
  if (!sink_ || attempt_ != attempt) return false;
  channel_ = std::move(channel);
  handle_ = handle;
  lost_.assign(wanted_.events.size(), 0);
  interruption_.reset();
  sink_->OnListening(events);
  return true;
}

bool Listening::Fail(std::uint32_t attempt, const Error& reason) {
  const std::scoped_lock lock(mutex_);
  if (attempt_ != attempt) return false;
  attempt_ = 0;
  channel_.reset();
  if (!sink_) return false;
  if (interruption_ != reason) sink_->OnStale(reason);
  interruption_ = reason;
  return true;
}

void Listening::End() {
  const std::scoped_lock lock(mutex_);
  sink_.reset();
  if (channel_) (void)channel_->Notify(message::kCloseInterface, handle_, Bytes());
  channel_.reset();
}

void Listening::Raise(std::uint32_t attempt, std::size_t event, std::span<const std::byte> value) {
  const std::scoped_lock lock(mutex_);
  if (!channel_ || attempt_ != attempt || event >= wanted_.events.size()) return;
  sink_->OnEvent(event, value);
}

void Listening::Lose(std::uint32_t attempt, const message::EventsLost& events) {
  const std::scoped_lock lock(mutex_);
  if (!channel_ || attempt_ != attempt) return;
  for (std::size_t i = 0; i < std::min(lost_.size(), events.lost.size()); ++i) {
    if (events.lost[i] <= lost_[i]) continue;
    sink_->OnEventsLost(i, events.lost[i] - std::exchange(lost_[i], events.lost[i]));
  }
}

}  // namespace tendon::client
