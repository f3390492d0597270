#pragma once

#include <tendon/payload/codec.h>
#include <tendon/state/state_table.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tendon {

/// A reader's copy of a whole row of a table. All columns belong to one cycle.
///
/// Create it when the table has all its columns; the table must outlive it. Reads allocate nothing.
/// Used by one thread at a time.
class RowCopy {
 public:
  explicit RowCopy(const StateTable& table) : table_(table), words_(table.row_words()) {}

  /// Copies the newest row. Returns kNoSample before the first row. Wait-free unless the writer
  /// overwrites the whole ring during the copy.
  Status ReadNewest();
  /// Copies the row with this tick. If the result is not kDone, the object holds no row afterwards.
  RowResult ReadAt(std::uint64_t tick);
  /// Copies the newest row that is not later than `time`.
  RowResult ReadAtTime(SteadyTime time);

  /// Identifies the copied row.
  [[nodiscard]] const RowStamp& stamp() const noexcept { return stamp_; }
  /// Reads the value of a column from the copied row. Returns kNotYet if no row was copied, and
  /// kAbsent if the value did not fit into the column. Allocates only if a dynamic `value` grows.
  template <Payload T>
  RowResult Get(const Column<T>& column, T& value) const {
    if (!has_row_) return RowResult::kNotYet;
    const auto body = Cell(column);
    if (body.empty()) return RowResult::kAbsent;
    return Decode(body, value) ? RowResult::kDone : RowResult::kInvalid;
  }
  /// Returns the CDR body of a column in the copied row; empty if its value is absent.
  [[nodiscard]] std::span<const std::byte> Cell(const ColumnBase& column) const noexcept;

 private:
  RowResult Note(RowResult result, std::int64_t time);

  const StateTable& table_;
  std::vector<std::uint64_t> words_;
  RowStamp stamp_;
  bool has_row_ = false;
};

}  // namespace tendon
