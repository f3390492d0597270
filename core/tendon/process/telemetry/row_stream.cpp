#include <tendon/process/telemetry/row_stream.h>

#include <tendon/process/viewer_messages.h>

#include <utility>

namespace tendon {

std::vector<std::uint32_t> CellSizes(const StateTable& table,
                                     const std::vector<std::size_t>& columns) {
  std::vector<std::uint32_t> sizes;
  for (const std::size_t column : columns) {
    const CellLayout& layout = table.columns()[column]->layout();
    sizes.push_back(layout.is_dynamic ? 0 : static_cast<std::uint32_t>(layout.bytes));
  }
  return sizes;
}

bool Includes(const RowAcknowledgements& acknowledgements, const std::shared_ptr<Channel>& channel,
              std::uint32_t handle) {
  const auto found = acknowledgements.find(channel);
  return found != acknowledgements.end() && found->second.contains(handle);
}

RowStream::RowStream(const StateTable& table, std::vector<std::size_t> columns, RowChoice rows)
    : table_(table),
      columns_(std::move(columns)),
      rows_(rows),
      batch_(CellSizes(table_, columns_)) {}

std::size_t RowStream::SubscriptionsOf(const Channel& viewer) const {
  return viewers_.CountOf(viewer) + (topic_ ? topic_->viewers().CountOf(viewer) : 0);
}

void RowStream::Add(std::shared_ptr<Channel> channel, std::uint32_t handle, Lane lane) {
  DirectViewer viewer;
  viewer.channel = std::move(channel);
  viewer.handle = handle;
  viewer.lane = lane;
  viewers_.Add(std::move(viewer));
}

const std::string& RowStream::AddToTopic(const MakeRowTopic& make, std::shared_ptr<Channel> channel,
                                         std::uint32_t handle) {
  if (!topic_) topic_ = make();
  topic_->viewers().Add({.channel = std::move(channel), .handle = handle});
  return topic_->name();
}

void RowStream::Remove(const Channel& channel, std::uint32_t handle) {
  viewers_.Remove(channel, handle);
  if (!topic_) return;
  topic_->viewers().Remove(channel, handle);
  if (topic_->viewers().empty()) topic_ = nullptr;
}

void RowStream::OnRowsTaken(const RowAcknowledgements& acknowledgements) {
  for (DirectViewer& viewer : viewers_) {
    if (viewer.is_busy && Includes(acknowledgements, viewer.channel, viewer.handle)) {
      viewer.is_busy = false;
    }
  }
}

void RowStream::RemoveClosed() {
  viewers_.RemoveClosed();
  if (!topic_) return;
  topic_->viewers().RemoveClosed();
  if (topic_->viewers().empty()) topic_ = nullptr;
}

bool RowStream::has_sent_all() const {
  const bool is_newest = rows_.delivery == RowDelivery::kNewest && batch_.rows() > 0;
  return std::ranges::all_of(viewers_, [&](const DirectViewer& viewer) {
    const bool is_behind = viewer.is_owed || (is_newest && viewer.next_tick <= newest_tick_);
    return !is_behind || !viewer.channel->is_open();
  });
}

void RowStream::Take(std::uint64_t tick, std::int64_t time, std::span<const std::uint64_t> row) {
  if (!Wants(time)) return;
  if (rows_.delivery == RowDelivery::kNewest) batch_.Clear();
  batch_.BeginRow(tick, time);
  for (const std::size_t column : columns_) batch_.AddCell(table_.cell(row, column));
  newest_tick_ = tick;
}

/// True for the very first row, and for the first row of each new period.
bool RowStream::Wants(std::int64_t time) {
  if (rows_.period.count() == 0) return true;
  return std::exchange(stretch_, time / rows_.period.count()) != time / rows_.period.count();
}

bool RowStream::is_full() const {
  // With one more row, a batch still fits into one piece.
  constexpr std::size_t kMaxBytes = std::size_t{128} << 10U;
  return rows_.delivery == RowDelivery::kAll && batch_.size() >= kMaxBytes;
}

void RowStream::Send(std::uint64_t lost, std::uint64_t next_tick) {
  if (rows_.delivery == RowDelivery::kNewest) {
    for (DirectViewer& viewer : viewers_) SendNewest(viewer, next_tick);
    return;
  }
  for (DirectViewer& viewer : viewers_) SendAll(viewer, lost, next_tick);
  if (topic_) topic_->Send(batch_, lost, next_tick);
  batch_.Clear();
}

void RowStream::SendAll(DirectViewer& viewer, std::uint64_t lost, std::uint64_t next_tick) {
  viewer.lost_table += lost;
  if (batch_.rows() == 0 && viewer.lost_table == 0 && !viewer.is_owed) return;
  const auto frame = batch_.FinishFrame(
      {.rows_before = viewer.rows_before, .lost_table = viewer.lost_table, .next_tick = next_tick});
  viewer.rows_before += batch_.rows();  // counted even if refused, so that the viewer sees the gap
  viewer.is_owed =
      !viewer.channel->NotifyInPlace(message::kRows, viewer.handle, frame, viewer.lane);
  if (!viewer.is_owed) viewer.lost_table = 0;
}

void RowStream::SendNewest(DirectViewer& viewer, std::uint64_t next_tick) {
  if (batch_.rows() == 0 || viewer.is_busy || viewer.next_tick > newest_tick_) return;
  const auto frame = batch_.FinishFrame(
      {.rows_before = viewer.rows_before, .lost_table = 0, .next_tick = next_tick});
  if (!viewer.channel->NotifyInPlace(message::kRows, viewer.handle, frame, viewer.lane)) return;
  viewer.is_busy = true;
  viewer.next_tick = newest_tick_ + 1;
  ++viewer.rows_before;
}

void RowStream::End(const Error& reason) {
  viewers_.EndAll(reason);
  if (topic_) topic_->viewers().EndAll(reason);
  topic_ = nullptr;
}

}  // namespace tendon
