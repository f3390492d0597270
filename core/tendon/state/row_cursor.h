#pragma once

#include <tendon/state/state_table.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tendon {

/// Reads the rows of a state table in order. Rows that were overwritten before they could be read
/// are skipped and counted.
///
/// Thread safety: one thread at a time. The table must outlive the cursor.
class RowCursor {
 public:
  /// Begins with the next row that is written.
  explicit RowCursor(const StateTable& table) : RowCursor(table, table.next_tick()) {}
  /// The columns of the table must be complete.
  RowCursor(const StateTable& table, std::uint64_t next_tick)
      : table_(table), next_tick_(next_tick), row_(table.row_words()) {}

  /// The tick of the next row.
  [[nodiscard]] std::uint64_t next_tick() const { return next_tick_; }

  /// Skips the rows that are already overwritten. Returns the tick after the newest row. Must be
  /// called before rows are read.
  std::uint64_t Begin();
  /// Copies the next row, which must exist. Returns false if the row was overwritten while it was
  /// read. In this case, skips to a newer row. Each repetition skips more rows. Also returns false,
  /// and skips this tick, if the writer has skipped it.
  bool Read(std::int64_t& time);
  /// Returns the last row that was read.
  [[nodiscard]] std::span<std::uint64_t> row() { return row_; }
  /// Returns the number of rows that were skipped since the last call.
  std::uint64_t TakeLost();

 private:
  const StateTable& table_;
  std::uint64_t next_tick_ = 0;
  std::uint64_t lost_ = 0;
  std::uint64_t head_start_ = 0;  // rows between the oldest row and the end of the last skip
  std::vector<std::uint64_t> row_;
};

}  // namespace tendon
