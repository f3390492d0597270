#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/error.h>
#include <tendon/state/column.h>
#include <tendon/state/filter.h>
#include <tendon/state/row_ring.h>

#include <chrono>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tendon {

/// Publishes chosen variables of a task to other threads and keeps their history. Each cycle
/// encodes all of these variables into one row of a ring.
///
/// Thread safety: functions that add or set something, and Prepare(), are called before the first
/// row. One thread writes rows, and only this thread changes the variables. Any thread may call all
/// other functions at any time. Writing is wait-free. If the writer overwrites the row that a
/// reader copies, the read returns kOvertaken.
class StateTable {
 public:
  /// The default number of rows is at least this, if kDefaultBytes are enough for it.
  static constexpr std::size_t kMinimumLength = 256;
  static constexpr std::size_t kMaximumLength = std::size_t{1} << 24;
  static constexpr std::size_t kDefaultBytes = std::size_t{16} << 20;
  /// The maximum size of a row. It ensures that a table can hold at least two rows.
  static constexpr std::size_t kMaximumRowBytes = kDefaultBytes / 2;

  explicit StateTable(std::string name = "state");
  StateTable(const StateTable&) = delete;
  StateTable& operator=(const StateTable&) = delete;

  /// Makes `variable`, which must outlive the table, a column. Throws ConfigurationError if the
  /// name or the variable is already a column, the table is prepared, or a row would exceed
  /// kMaximumRowBytes.
  template <typename T>
  requires(FixedPayload<T> || !Payload<T>) void Add(const T& variable, std::string name) {
    static_assert(RequirePayload<T>());
    if constexpr (Payload<T>) {
      AddColumn<T>(variable, std::move(name), {.bytes = kEncodedSize<T>, .is_dynamic = false});
    }
  }
  /// Makes a variable of a dynamic type a column. A value of more than `capacity` bytes on the wire
  /// is left out of its row. Then reads return kAbsent, and the column counts the value as absent.
  template <typename T>
  requires(!FixedPayload<T>) void Add(const T& variable, std::string name, std::size_t capacity) {
    static_assert(RequirePayload<T>());
    if constexpr (Payload<T>) {
      AddColumn<T>(variable, std::move(name), {.bytes = capacity, .is_dynamic = true});
    }
  }

  /// Makes `body` a column of a type that is known only at run time: before each row it must hold a
  /// CDR body of `schema`. A body that is empty, or has more than `capacity` bytes, is left out of
  /// its row. Fails like Add().
  void AddEncoded(const std::vector<std::byte>& body, const Schema& schema, std::string name,
                  std::size_t capacity);

  /// Makes `output` a column. `filter(input, output)`, which must be noexcept, computes `output`
  /// from `input` just before each row, in the writer's thread. Filters run in the order in which
  /// they were added, so a filter may use the result of an earlier one. `name` and `capacity` have
  /// the same meaning as in Add().
  template <typename In, typename Out, typename Filter, std::integral... Capacity>
  void AddFiltered(const In& input, Out& output, Filter filter, std::string name,
                   Capacity... capacity) {
    static_assert(RequirePayload<In>());
    Add(output, std::move(name), static_cast<std::size_t>(capacity)...);
    filters_.push_back(
        std::make_unique<FunctionFilter<In, Out, Filter>>(input, output, std::move(filter)));
  }

  /// Sets the number of newest rows that can be read; the table may keep more. kDefaultBytes does
  /// not limit this number. Throws ConfigurationError if `rows` is not 1 to kMaximumLength, or if
  /// rows have been written. Reallocates the rows if they exist.
  void SetLength(std::size_t rows);
  /// The default length of a table whose rows have `row_bytes`: the number of rows that cycles of
  /// `period` write in one second. The result is at least kMinimumLength, and at most as many rows
  /// as kDefaultBytes can hold.
  [[nodiscard]] static std::size_t LengthFor(std::chrono::nanoseconds period,
                                             std::size_t row_bytes) noexcept;
  /// The default length of this table, with the columns that it has now.
  [[nodiscard]] std::size_t LengthFor(std::chrono::nanoseconds period) const noexcept {
    return LengthFor(period, row_words_ * sizeof(std::uint64_t));
  }
  /// From now on, cycles write no rows; the author's code calls Advance().
  void AdvanceOnlyByHand() noexcept { is_by_hand_ = true; }
  /// Sets the shortest time between two rows written by cycles. With 0, the default, each cycle
  /// writes a row.
  void SetShortestInterval(std::chrono::nanoseconds interval) noexcept { interval_ = interval; }
  /// From now on, no column can be added. Allocates the rows and touches their memory, so that the
  /// first cycle has no page faults.
  void Prepare();
  /// Encodes every variable into a new row, which becomes the newest. Calls Prepare() if the
  /// program has not done so. Allocates nothing after Prepare().
  void Advance(SteadyTime now) noexcept;
  /// Gives the first row this tick instead of 0. Used for a copy of another table. Throws
  /// ConfigurationError if there are rows.
  void SetFirstTick(std::uint64_t tick);
  /// Like Advance(), but skips the ticks before `tick`, which count as overwritten. `tick` must not
  /// be below next_tick(). For the first row, `tick` must be the tick that SetFirstTick() has set.
  void AdvanceTo(std::uint64_t tick, SteadyTime now) noexcept;
  /// Called by a task after its cycle. Calls Advance(), unless AdvanceOnlyByHand() was called or
  /// the shortest interval has not passed.
  void AdvanceAfterCycle(SteadyTime now) noexcept {
    if (is_by_hand_ || (interval_.count() > 0 && IsTooEarly(now))) return;
    Advance(now);
  }

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// The length that SetLength() has set; 0 if it is not set yet.
  [[nodiscard]] std::size_t length() const noexcept { return length_; }
  /// A random number that distinguishes the ticks of this table from the ticks of an earlier table
  /// with the same name.
  [[nodiscard]] std::uint64_t epoch() const noexcept { return epoch_; }
  /// The tick of the next row: the number of rows written, unless the table is a copy
  /// (SetFirstTick()).
  [[nodiscard]] std::uint64_t next_tick() const noexcept { return rows_.next_tick(); }
  /// The tick of the oldest row that can still be read.
  [[nodiscard]] std::uint64_t oldest_tick() const noexcept { return rows_.oldest_tick(); }
  /// Finds the newest row that is not later than `time`. Returns kNotYet if all rows are later, and
  /// kOvertaken if this row is lost. Uses a binary search.
  RowResult FindRow(SteadyTime time, std::uint64_t& tick) const noexcept {
    return rows_.Find(time.time_since_epoch().count(), tick);
  }

  /// All columns, in the order in which they were added.
  [[nodiscard]] std::span<const std::unique_ptr<ColumnBase>> columns() const noexcept {
    return columns_;
  }
  /// Returns the column with this name; null if no column has it.
  [[nodiscard]] const ColumnBase* Find(std::string_view name) const noexcept;
  /// Returns the column of `variable`. Throws ConfigurationError if `variable` is not a column of
  /// the table.
  template <Payload T>
  [[nodiscard]] const Column<T>& Find(const T& variable) const {
    return static_cast<const Column<T>&>(Find(&variable, typeid(T)));
  }

  /// Copies all cells of a row into `words`, which must have room for row_words().
  /// ColumnBase::Cell() then reads single cells. Never returns kAbsent or kInvalid. RowCopy is more
  /// convenient.
  RowResult CopyRow(std::uint64_t tick, std::span<std::uint64_t> words,
                    std::int64_t& time_ns) const noexcept;
  /// Like CopyRow(), but for the newest row. Returns kDone, or kNotYet before the first row.
  RowResult CopyNewestRow(std::uint64_t& tick, std::span<std::uint64_t> words,
                          std::int64_t& time_ns) const noexcept;
  /// Size of all cells of a row, in 64-bit words.
  [[nodiscard]] std::size_t row_words() const noexcept { return row_words_; }
  /// Returns the CDR body of a column in a row that CopyRow() has copied; empty if its value was
  /// absent.
  [[nodiscard]] std::span<const std::byte> cell(std::span<const std::uint64_t> words,
                                                std::size_t column) const noexcept {
    return columns_[column]->Cell(words);
  }

 private:
  template <Payload T>
  void AddColumn(const T& variable, std::string name, CellLayout layout) {
    CheckColumn(name, &variable, typeid(T), layout.bytes);
    layout.offset = row_words_;
    layout.words = (layout.bytes + 7) / 8 + (layout.is_dynamic ? 1 : 0);
    Append(std::make_unique<Column<T>>(rows_, variable, std::move(name), layout));
  }
  void CheckColumn(const std::string& name, const void* variable, const std::type_info& type,
                   std::size_t bytes) const;
  void Append(std::unique_ptr<ColumnBase> column);
  [[nodiscard]] const ColumnBase& Find(const void* variable, const std::type_info& type) const;
  [[nodiscard]] bool IsTooEarly(SteadyTime now) const noexcept;

  std::string name_;
  std::uint64_t epoch_;
  std::size_t length_ = 0;
  std::size_t row_words_ = 0;
  std::vector<std::unique_ptr<ColumnBase>> columns_;
  std::vector<std::unique_ptr<RowFilter>> filters_;
  std::vector<std::uint64_t> row_;  // the row that the writer encodes
  bool is_prepared_ = false;
  bool is_by_hand_ = false;
  std::chrono::nanoseconds interval_{0};
  SteadyTime last_;  // time of the newest row, in the writer's thread
  RowRing<> rows_;
};

}  // namespace tendon
