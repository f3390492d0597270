#include <tendon/process/log/log_forwarder.h>

#include <algorithm>
#include <utility>

namespace tendon {

LogForwarder::LogForwarder(std::shared_ptr<NetworkThread> network)
    : network_(std::move(network)),
      tap_([this](LogLevel level, std::string_view source, std::string_view text) {
        Add(level, source, text);
      }) {
  network_->Add(*this);
}

LogForwarder::~LogForwarder() { network_->Remove(*this); }

void LogForwarder::Add(LogLevel level, std::string_view source, std::string_view text) {
  if (queue_.Add(level, source, text)) network_->Notify();
}

void LogForwarder::SetChannel(std::shared_ptr<Channel> channel) {
  {
    const std::scoped_lock lock(mutex_);
    channel_ = std::move(channel);
  }
  network_->Notify();
}

void LogForwarder::Finish() {
  const std::scoped_lock lock(mutex_);
  if (channel_) Send(SteadyTime::max());
  channel_ = nullptr;
}

bool LogForwarder::Work(SteadyTime now, SteadyTime& next) {
  const std::scoped_lock lock(mutex_);
  if (!channel_ || (unsent_.empty() && !queue_.has_news())) return false;
  if (now >= next_batch_) {
    Send(now);
    next_batch_ = now + kBetweenBatches;
  }
  next = std::min(next, next_batch_);
  return false;
}

/// Sends the queued records. Called with the lock held, while there is a channel. Reports
/// suppressed records only once per call. Otherwise, a source that logs without pause would keep
/// this loop running.
void LogForwarder::Send(SteadyTime now) {
  while (true) {
    if (unsent_.empty()) {
      const auto records = queue_.Take(kMaxInBatch, std::exchange(now, SteadyTime{}));
      if (records.empty()) return;
      unsent_ = EncodeBody(message::LogRecords{sent_, records});
      sent_ += records.size();
    }
    if (!channel_->Notify(message::kLogRecords, 0, unsent_)) return;
    unsent_.clear();
  }
}

}  // namespace tendon
