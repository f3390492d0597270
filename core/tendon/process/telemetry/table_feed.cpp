#include <tendon/process/messages.h>
#include <tendon/process/telemetry/table_feed.h>

#include <algorithm>

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

TableFeed::TableFeed(std::string component, const StateTable& table,
                     std::vector<std::size_t> columns)
    : component_(std::move(component)),
      table_(table),
      columns_(std::move(columns)),
      batch_(CellSizes(table_, columns_)),
      next_tick_(table_.next_tick()),
      row_(table_.row_words()) {}

void TableFeed::Add(std::shared_ptr<Channel> channel, std::uint32_t handle) {
  viewers_.push_back(
      {.channel = std::move(channel), .handle = handle, .rows_before = 0, .lost_table = 0});
}

void TableFeed::Remove(const Channel& channel, std::uint32_t handle) {
  std::erase_if(viewers_, [&](const Viewer& viewer) {
    return viewer.channel.get() == &channel && viewer.handle == handle;
  });
}

bool TableFeed::Gather() {
  constexpr int kBatchesInARow = 4;
  std::erase_if(viewers_, [](const Viewer& viewer) { return !viewer.channel->is_open(); });
  for (int batch = 0; batch < kBatchesInARow; ++batch) {
    if (!GatherBatch()) return false;
  }
  return true;
}

bool TableFeed::GatherBatch() {
  constexpr std::size_t kMostBytes = std::size_t{256} << 10U;
  const std::uint64_t end = table_.next_tick();
  const std::uint64_t first = std::clamp(table_.oldest_tick(), next_tick_, end);
  std::uint64_t lost = first - next_tick_;
  batch_.Clear();
  for (next_tick_ = first; next_tick_ < end && batch_.size() < kMostBytes; ++next_tick_) {
    std::int64_t time = 0;
    if (table_.CopyRow(next_tick_, row_, time) != RowResult::kDone) {
      ++lost;
      continue;
    }
    batch_.BeginRow(next_tick_, time);
    for (const std::size_t column : columns_) batch_.AddCell(table_.cell(row_, column));
  }
  if (batch_.rows() > 0 || lost > 0) SendBatch(lost);
  return batch_.rows() > 0;
}

void TableFeed::SendBatch(std::uint64_t lost) {
  for (Viewer& viewer : viewers_) {
    viewer.lost_table += lost;
    const auto body = batch_.Finish(viewer.rows_before, viewer.lost_table);
    viewer.rows_before += batch_.rows();  // whether it arrives or not: the viewer sees the hole
    if (viewer.channel->Notify(message::kRows, viewer.handle, body)) viewer.lost_table = 0;
  }
}

void TableFeed::End(const Error& reason) {
  for (const Viewer& viewer : viewers_) {
    const Status told = viewer.channel->Notify(message::kRowsEnded, viewer.handle, reason);
    // Not told, it would wait for rows for ever; it opens the channel again, and hears why.
    if (told == Status(Status::kQueueFull)) viewer.channel->Close();
  }
  viewers_.clear();
}

}  // namespace tendon
