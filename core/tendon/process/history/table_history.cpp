#include <tendon/process/history/table_history.h>

#include <tendon/payload/codec.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

namespace tendon {

TableHistory::TableHistory(std::string component, const StateTable& table, HistoryMemory& memory,
                           std::chrono::nanoseconds span)
    : component_(std::move(component)),
      table_(table),
      first_tick_(table.next_tick()),
      ring_(memory, span),
      looked_(SteadyClock().Now()),
      looked_at_tick_(first_tick_) {}

bool TableHistory::Gather(SteadyTime now) {
  constexpr std::size_t kMaxBytes = std::size_t{64} << 10U;
  if (!rows_) {
    if (table_.next_tick() == first_tick_) return false;
    rows_.emplace(table_, first_tick_);
  }
  const std::uint64_t end = rows_->Begin();
  std::size_t bytes = 0;
  while (rows_->next_tick() < end && bytes < kMaxBytes) {
    const std::uint64_t tick = rows_->next_tick();
    std::int64_t time = 0;
    if (!rows_->Read(time)) continue;
    try {
      Encode();
      ring_.Append({.number = tick, .time = time, .tag = 0, .body = body_});
    } catch (const std::bad_alloc&) {
      ++missed_;
    }
    bytes += body_.size();
  }
  missed_ += rows_->TakeLost();
  const bool has_more = rows_->next_tick() < end;
  if (!has_more) EstimateNextRead(now);
  return has_more;
}

/// Writes all cells of the row one after the other, each at a multiple of 8 bytes. The size of a
/// cell of variable size is written before the cell.
void TableHistory::Encode() {
  body_.clear();
  const auto columns = table_.columns();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto cell = table_.cell(rows_->row(), i);
    if (columns[i]->layout().is_dynamic) {
      const std::uint64_t size = cell.size();
      const auto bytes = std::as_bytes(std::span(&size, 1));
      body_.insert(body_.end(), bytes.begin(), bytes.end());
    }
    body_.insert(body_.end(), cell.begin(), cell.end());
    body_.resize(payload::AlignUp(body_.size(), 8));
  }
}

void TableHistory::ReadCells(const HistoryRecord& record,
                             std::vector<std::span<const std::byte>>& cells) const {
  cells.clear();
  std::size_t position = 0;
  for (const auto& column : table_.columns()) {
    std::uint64_t size = column->layout().bytes;
    if (column->layout().is_dynamic) {
      std::memcpy(&size, record.body.data() + position, sizeof size);
      position += sizeof size;
    }
    cells.push_back(record.body.subspan(position, size));
    position += payload::AlignUp(size, 8);
  }
}

/// Sets the time until the next read to a quarter of the time in which the whole table is
/// overwritten at the rate of the last rows.
void TableHistory::EstimateNextRead(SteadyTime now) {
  const std::uint64_t next = rows_->next_tick();
  const std::uint64_t written = next - std::exchange(looked_at_tick_, next);
  const std::chrono::duration<double> time = now - std::exchange(looked_, now);
  until_next_read_ = std::chrono::nanoseconds::max();
  if (written == 0) return;
  const auto held = static_cast<double>(next - table_.oldest_tick());
  constexpr double kPart = 0.25;
  constexpr std::chrono::seconds kLongest(10);
  until_next_read_ =
      std::chrono::duration_cast<std::chrono::nanoseconds>(std::min<std::chrono::duration<double>>(
          time * kPart * held / static_cast<double>(written), kLongest));
}

}  // namespace tendon
