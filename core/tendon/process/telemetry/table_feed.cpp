#include <tendon/process/telemetry/table_feed.h>

#include <algorithm>
#include <utility>

namespace tendon {

TableFeed::TableFeed(std::string component, const StateTable& table)
    : component_(std::move(component)), table_(table), rows_(table_) {}

void TableFeed::Add(const std::vector<std::size_t>& columns, const RowChoice& rows,
                    std::shared_ptr<Channel> channel, std::uint32_t handle, Lane lane) {
  const bool is_new =
      std::ranges::none_of(streams_, [&](const RowStream& one) { return one.IsOf(columns, rows); });
  RowStream& stream = StreamOf(columns, rows);
  if (is_new && rows.delivery == RowDelivery::kNewest) TakeNewest(stream);
  stream.Add(std::move(channel), handle, lane);
}

void TableFeed::TakeNewest(RowStream& stream) {
  std::uint64_t tick = 0;
  std::int64_t time = 0;
  const bool is_there = table_.CopyNewestRow(tick, rows_.row(), time) == RowResult::kDone;
  if (is_there && tick < next_tick()) stream.Take(tick, time, rows_.row());
}

const std::string& TableFeed::AddToTopic(const std::vector<std::size_t>& columns,
                                         const MakeRowTopic& make, std::shared_ptr<Channel> channel,
                                         std::uint32_t handle) {
  return StreamOf(columns, {}).AddToTopic(make, std::move(channel), handle);
}

RowStream& TableFeed::StreamOf(const std::vector<std::size_t>& columns, const RowChoice& rows) {
  const auto stream = std::find_if(streams_.begin(), streams_.end(),
                                   [&](const RowStream& one) { return one.IsOf(columns, rows); });
  return stream != streams_.end() ? *stream : streams_.emplace_back(table_, columns, rows);
}

void TableFeed::Remove(const Channel& channel, std::uint32_t handle) {
  for (RowStream& stream : streams_) stream.Remove(channel, handle);
  RemoveUnwatched();
}

void TableFeed::OnRowsTaken(const RowAcknowledgements& acknowledgements) {
  for (RowStream& stream : streams_) stream.OnRowsTaken(acknowledgements);
}

std::size_t TableFeed::SubscriptionsOf(const Channel& viewer) const {
  std::size_t count = 0;
  for (const RowStream& stream : streams_) count += stream.SubscriptionsOf(viewer);
  return count;
}

std::size_t TableFeed::CellsFor(const Channel& viewer, const std::vector<std::size_t>& columns,
                                const RowChoice& rows) const {
  std::size_t cells = std::max<std::size_t>(1, columns.size());
  for (const RowStream& stream : streams_) {
    if (!stream.IsOf(columns, rows) && stream.SubscriptionsOf(viewer) > 0) cells += stream.width();
  }
  return cells;
}

bool TableFeed::Gather() {
  for (RowStream& stream : streams_) stream.RemoveClosed();
  RemoveUnwatched();
  has_more_ = false;
  if (!has_viewers()) return false;
  const std::uint64_t end = rows_.Begin();
  while (next_tick() < end && !IsBatchFull()) {
    const std::uint64_t tick = next_tick();
    std::int64_t time = 0;
    if (!rows_.Read(time)) continue;
    for (RowStream& stream : streams_) stream.Take(tick, time, rows_.row());
  }
  const std::uint64_t lost = rows_.TakeLost();
  for (RowStream& stream : streams_) stream.Send(lost, next_tick());
  has_more_ = next_tick() < end;
  return has_more_;
}

bool TableFeed::HasSentAll() const {
  if (!has_viewers()) return true;
  return next_tick() >= table_.next_tick() &&
         std::ranges::all_of(streams_, [](const RowStream& one) { return one.has_sent_all(); });
}

bool TableFeed::IsBatchFull() const {
  return std::any_of(streams_.begin(), streams_.end(),
                     [](const RowStream& stream) { return stream.is_full(); });
}

void TableFeed::RemoveUnwatched() {
  streams_.remove_if([](const RowStream& stream) { return !stream.has_viewers(); });
}

void TableFeed::End(const Error& reason) {
  for (RowStream& stream : streams_) stream.End(reason);
  streams_.clear();
}

}  // namespace tendon
