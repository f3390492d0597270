#pragma once

#include <tendon/base/clock.h>
#include <tendon/process/history/history_ring.h>
#include <tendon/state/row_cursor.h>
#include <tendon/state/state_table.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// Keeps the rows of one state table for longer than the table does. The numbers of the records are
/// the ticks of the rows.
///
/// Thread safety: one thread at a time. The table must outlive the history.
class TableHistory {
 public:
  TableHistory(std::string component, const StateTable& table, HistoryMemory& memory,
               std::chrono::nanoseconds span);

  [[nodiscard]] const std::string& component() const { return component_; }
  [[nodiscard]] const StateTable& table() const { return table_; }
  [[nodiscard]] const HistoryRing& ring() const { return ring_; }
  [[nodiscard]] HistoryRing& ring() { return ring_; }
  /// Returns the number of rows that were not copied, because they were already overwritten in the
  /// table or because memory was exhausted.
  [[nodiscard]] std::uint64_t missed() const { return missed_; }

  /// Copies new rows, at most about 64 KiB. Returns true if more rows are left.
  bool Gather(SteadyTime now);
  /// Returns the time within which Gather() must be called again, so that no row is overwritten
  /// before. Returns the largest value if there were no new rows.
  [[nodiscard]] std::chrono::nanoseconds until_next_read() const { return until_next_read_; }

  /// Fills in the cells of all columns of a record of this ring.
  void ReadCells(const HistoryRecord& record, std::vector<std::span<const std::byte>>& cells) const;

 private:
  void Encode();
  void EstimateNextRead(SteadyTime now);

  const std::string component_;
  const StateTable& table_;
  const std::uint64_t first_tick_;
  HistoryRing ring_;
  // Empty before the first row, because columns may be added until then.
  std::optional<RowCursor> rows_;
  std::vector<std::byte> body_;
  std::uint64_t missed_ = 0;
  SteadyTime looked_;                 // the time of the last estimate
  std::uint64_t looked_at_tick_ = 0;  // the next tick at that time
  std::chrono::nanoseconds until_next_read_ = std::chrono::nanoseconds::max();
};

}  // namespace tendon
