#include <tendon/process/telemetry/row_stream.h>
#include <tendon/process/viewer_messages.h>

#include <algorithm>
#include <utility>

namespace tendon {
namespace {

std::vector<std::uint32_t> CellSizes(const StateTable& table,
                                     const std::vector<std::size_t>& columns) {
  std::vector<std::uint32_t> sizes;
  for (const std::size_t column : columns) {
    const CellLayout& layout = table.columns()[column]->layout();
    sizes.push_back(layout.is_dynamic ? 0 : static_cast<std::uint32_t>(layout.bytes));
  }
  return sizes;
}

}  // namespace

RowStream::RowStream(const StateTable& table, std::vector<std::size_t> columns, RowChoice rows)
    : table_(table),
      columns_(std::move(columns)),
      rows_(rows),
      batch_(CellSizes(table_, columns_)) {}

std::size_t RowStream::SubscriptionsOf(const Channel& viewer) const {
  const auto count = std::ranges::count_if(
      viewers_, [&](const Viewer& one) { return one.channel.get() == &viewer; });
  return static_cast<std::size_t>(count) + (topic_ ? topic_->SubscriptionsOf(viewer) : 0);
}

void RowStream::Add(std::shared_ptr<Channel> channel, std::uint32_t handle, Lane lane) {
  Viewer viewer;
  viewer.lane = lane;
  viewer.channel = std::move(channel);
  viewer.handle = handle;
  viewers_.push_back(std::move(viewer));
}

const std::string& RowStream::AddToTopic(const MakeRowTopic& make, std::shared_ptr<Channel> channel,
                                         std::uint32_t handle) {
  if (!topic_) topic_ = make();
  topic_->Add(std::move(channel), handle);
  return topic_->name();
}

void RowStream::Remove(const Channel& channel, std::uint32_t handle) {
  std::erase_if(viewers_, [&](const Viewer& viewer) {
    return viewer.channel.get() == &channel && viewer.handle == handle;
  });
  if (!topic_) return;
  topic_->Remove(channel, handle);
  if (!topic_->has_viewers()) topic_ = nullptr;
}

void RowStream::OnRowsTaken(const RowAcknowledgements& receipts) {
  for (Viewer& viewer : viewers_) {
    if (viewer.is_busy && Includes(receipts, viewer.channel, viewer.handle)) viewer.is_busy = false;
  }
}

void RowStream::RemoveClosed() {
  std::erase_if(viewers_, [](const Viewer& viewer) { return !viewer.channel->is_open(); });
  if (!topic_) return;
  topic_->RemoveClosed();
  if (!topic_->has_viewers()) topic_ = nullptr;
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
  constexpr std::size_t kMostBytes = std::size_t{128} << 10U;  // plus one row fits into one piece
  return rows_.delivery == RowDelivery::kAll && batch_.size() >= kMostBytes;
}

void RowStream::Send(std::uint64_t lost, std::uint64_t next_tick) {
  if (rows_.delivery == RowDelivery::kNewest) {
    for (Viewer& viewer : viewers_) SendNewest(viewer, next_tick);
    return;
  }
  for (Viewer& viewer : viewers_) SendAll(viewer, lost, next_tick);
  if (topic_) topic_->Send(batch_, lost, next_tick);
  batch_.Clear();
}

void RowStream::SendAll(Viewer& viewer, std::uint64_t lost, std::uint64_t next_tick) {
  viewer.lost_table += lost;
  if (batch_.rows() == 0 && viewer.lost_table == 0 && !viewer.is_owed) return;
  const auto frame = batch_.FinishFrame(
      {.rows_before = viewer.rows_before, .lost_table = viewer.lost_table, .next_tick = next_tick});
  viewer.rows_before += batch_.rows();  // even if refused: the viewer sees the gap
  viewer.is_owed =
      !viewer.channel->NotifyInPlace(message::kRows, viewer.handle, frame, viewer.lane);
  if (!viewer.is_owed) viewer.lost_table = 0;
}

void RowStream::SendNewest(Viewer& viewer, std::uint64_t next_tick) {
  if (batch_.rows() == 0 || viewer.is_busy || viewer.next_tick > newest_tick_) return;
  const auto frame = batch_.FinishFrame(
      {.rows_before = viewer.rows_before, .lost_table = 0, .next_tick = next_tick});
  if (!viewer.channel->NotifyInPlace(message::kRows, viewer.handle, frame, viewer.lane)) return;
  viewer.is_busy = true;
  viewer.next_tick = newest_tick_ + 1;
  ++viewer.rows_before;
}

void RowStream::End(const Error& reason) {
  for (const Viewer& viewer : viewers_) {
    const Status told =
        viewer.channel->Notify(message::kRowsEnded, viewer.handle, reason, viewer.lane);
    // Otherwise the viewer would wait for rows for ever. It opens the channel again, and gets the
    // reason then.
    if (told == Status(Status::kQueueFull)) viewer.channel->Close();
  }
  viewers_.clear();
  if (topic_) topic_->End(reason);
  topic_ = nullptr;
}

}  // namespace tendon
