#include <tendon/state/row_copy.h>

#include <algorithm>
#include <cassert>

namespace tendon {

Status RowCopy::ReadNewest() {
  std::int64_t time = 0;
  const RowResult result = table_.CopyNewestRow(stamp_.tick, words_, time);
  return ToStatus(Note(result, time));
}

RowResult RowCopy::ReadAt(std::uint64_t tick) {
  std::int64_t time = 0;
  stamp_.tick = tick;
  const RowResult result = table_.CopyRow(tick, words_, time);
  return Note(result, time);
}

RowResult RowCopy::ReadAtTime(SteadyTime time) {
  std::uint64_t tick = 0;
  const RowResult found = table_.FindRow(time, tick);
  return found == RowResult::kDone ? ReadAt(tick) : Note(found, 0);
}

std::span<const std::byte> RowCopy::Cell(const ColumnBase& column) const noexcept {
  assert(
      std::ranges::any_of(table_.columns(), [&](const auto& one) { return one.get() == &column; }));
  return column.Cell(words_);
}

RowResult RowCopy::Note(RowResult result, std::int64_t time) {
  has_row_ = result == RowResult::kDone;
  stamp_.time = SteadyTime(std::chrono::nanoseconds(time));
  return result;
}

}  // namespace tendon
