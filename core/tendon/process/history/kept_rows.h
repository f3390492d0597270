#pragma once

#include <tendon/base/clock.h>
#include <tendon/process/history/table_history.h>
#include <tendon/state/state_table.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tendon {

/// Reads all rows of a state table that this process still has, in the order of their ticks: first
/// the rows in the history, then the newer rows in the table. A row that is in both is read once.
///
/// Thread safety: one thread at a time. The history must not change meanwhile.
class KeptRows {
 public:
  /// `history` is null if the process keeps no rows of the table.
  KeptRows(const StateTable& table, const TableHistory* history);

  /// Returns the tick of the first row that is not older than `from`. If there is none, returns the
  /// tick of the next row that will be written.
  [[nodiscard]] std::uint64_t FirstTick(SteadyTime from) const;
  /// Reads the first kept row whose tick is at least `tick` and below `end`. Returns its tick, or
  /// `end` if there is none. `tick` must grow from call to call.
  std::uint64_t Read(std::uint64_t tick, std::uint64_t end);

  // These functions return parts of the row that was read last.
  [[nodiscard]] std::int64_t time() const { return time_; }
  [[nodiscard]] std::span<const std::byte> cell(std::size_t column) const {
    return is_from_history_ ? cells_[column] : table_.cell(row_, column);
  }

 private:
  [[nodiscard]] bool ReadFromHistory(std::uint64_t tick);

  const StateTable& table_;
  const TableHistory* const history_;
  std::optional<HistoryRing::Cursor> cursor_;
  std::optional<HistoryRecord> kept_;  // the first record that has not been read yet
  std::vector<std::uint64_t> row_;
  std::vector<std::span<const std::byte>> cells_;
  std::int64_t time_ = 0;
  bool is_from_history_ = false;
};

}  // namespace tendon
