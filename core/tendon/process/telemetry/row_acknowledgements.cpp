#include <tendon/process/telemetry/row_acknowledgements.h>

#include <utility>

namespace tendon {

bool Includes(const RowAcknowledgements& receipts, const std::shared_ptr<Channel>& channel,
              std::uint32_t handle) {
  const auto found = receipts.find(channel);
  return found != receipts.end() && found->second.contains(handle);
}

void AcknowledgementQueue::Add(const std::shared_ptr<Channel>& channel, std::uint32_t handle) {
  std::unique_lock lock(mutex_);
  auto& handles = receipts_[channel];
  if (handles.size() < kMostOfOneViewer || handles.contains(handle)) {
    handles.insert(handle);
    has_some_.Set(true);
    return;
  }
  lock.unlock();
  channel->CutOff("acknowledged rows of more subscriptions than it can have");
}

RowAcknowledgements AcknowledgementQueue::TakeAll() {
  if (!has_some_.Get()) return {};
  const std::scoped_lock lock(mutex_);
  has_some_.Set(false);
  return std::exchange(receipts_, {});
}

}  // namespace tendon
