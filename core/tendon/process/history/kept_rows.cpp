#include <tendon/process/history/kept_rows.h>

#include <algorithm>

namespace tendon {

KeptRows::KeptRows(const StateTable& table, const TableHistory* history)
    : table_(table), history_(history), row_(table.row_words()) {}

std::uint64_t KeptRows::FirstTick(SteadyTime from) const {
  if (table_.next_tick() == 0) return 0;  // the table may still be allocating its memory
  std::uint64_t before = 0;
  const bool is_found = table_.FindRow(from, before) == RowResult::kDone;
  const std::uint64_t first = is_found ? before + 1 : table_.oldest_tick();
  if (history_ == nullptr) return first;
  const auto kept = history_->ring().Since(from.time_since_epoch().count()).Next();
  return kept ? std::min(first, kept->number) : first;
}

std::uint64_t KeptRows::Read(std::uint64_t tick, std::uint64_t end) {
  while (tick < end) {
    is_from_history_ = ReadFromHistory(tick);
    if (is_from_history_) return tick;
    if (table_.CopyRow(tick, row_, time_) == RowResult::kDone) return tick;
    const std::uint64_t next = std::clamp(table_.oldest_tick(), tick + 1, end);
    tick = kept_ ? std::min(next, kept_->number) : next;
  }
  return end;
}

bool KeptRows::ReadFromHistory(std::uint64_t tick) {
  if (history_ == nullptr) return false;
  if (!cursor_) {
    cursor_ = history_->ring().From(tick);
    kept_ = cursor_->Next();
  }
  while (kept_ && kept_->number < tick) kept_ = cursor_->Next();
  if (!kept_ || kept_->number != tick) return false;
  history_->ReadCells(*kept_, cells_);
  time_ = kept_->time;
  return true;
}

}  // namespace tendon
