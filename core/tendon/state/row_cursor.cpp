#include <tendon/state/row_cursor.h>

#include <algorithm>
#include <utility>

namespace tendon {

std::uint64_t RowCursor::Begin() {
  const std::uint64_t end = table_.next_tick();
  // oldest_tick() is not called before the first row, because the table may still be allocating its
  // memory.
  const std::uint64_t first = end == 0 ? 0 : std::clamp(table_.oldest_tick(), next_tick_, end);
  lost_ += first - std::exchange(next_tick_, first);
  return end;
}

bool RowCursor::Read(std::int64_t& time) {
  if (table_.CopyRow(next_tick_, row_, time) == RowResult::kDone) {
    ++next_tick_;
    head_start_ = 0;
    return true;
  }
  const std::uint64_t oldest = table_.oldest_tick();
  if (next_tick_ >= oldest) {  // the writer has skipped this tick; see AdvanceTo()
    ++next_tick_;
    ++lost_;
    return false;
  }
  const std::uint64_t newest = table_.next_tick() - 1;
  head_start_ = std::min(2 * head_start_ + 1, (newest - oldest) / 2);
  const std::uint64_t next = std::max(next_tick_ + 1, oldest + head_start_);
  lost_ += next - std::exchange(next_tick_, next);
  return false;
}

std::uint64_t RowCursor::TakeLost() { return std::exchange(lost_, 0); }

}  // namespace tendon
