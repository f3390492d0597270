#include <tendon/process/telemetry/row_topic.h>
#include <tendon/process/viewer_messages.h>

#include <algorithm>
#include <utility>

namespace tendon {

void RowTopic::Add(std::shared_ptr<Channel> channel, std::uint32_t handle) {
  viewers_.push_back({.channel = std::move(channel), .handle = handle});
}

void RowTopic::Remove(const Channel& channel, std::uint32_t handle) {
  std::erase_if(viewers_, [&](const Viewer& viewer) {
    return viewer.channel.get() == &channel && viewer.handle == handle;
  });
}

void RowTopic::RemoveClosed() {
  std::erase_if(viewers_, [](const Viewer& viewer) { return !viewer.channel->is_open(); });
}

std::size_t RowTopic::SubscriptionsOf(const Channel& viewer) const {
  const auto count = std::ranges::count_if(
      viewers_, [&](const Viewer& one) { return one.channel.get() == &viewer; });
  return static_cast<std::size_t>(count);
}

void RowTopic::Send(RowBatchWriter& batch, std::uint64_t lost, std::uint64_t next_tick) {
  constexpr int kLongestQuiet = 25;  // in calls: half a second
  lost_table_ += lost;
  ++silence_;
  if (batch.rows() == 0 && lost_table_ == 0 && silence_ < kLongestQuiet) return;
  const auto body = batch.Finish(
      {.rows_before = rows_before_, .lost_table = lost_table_, .next_tick = next_tick});
  rows_before_ += batch.rows();  // even if refused: viewers see the gap
  if (!topic_->Publish(body)) return;
  lost_table_ = 0;
  silence_ = 0;
}

void RowTopic::End(const Error& reason) {
  for (const Viewer& viewer : viewers_) {
    const Status told = viewer.channel->Notify(message::kRowsEnded, viewer.handle, reason);
    if (told == Status(Status::kQueueFull)) viewer.channel->Close();
  }
  viewers_.clear();
}

}  // namespace tendon
