#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/error.h>
#include <tendon/state/column.h>
#include <tendon/state/row_ring.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tendon {

/// Publishes chosen variables of a task to other threads and keeps their history: each cycle all of
/// them become one row, encoded, in a ring of rows.
///
/// Thread safety: Add(), SetLength() and Prepare() before the first Advance(); Advance() by one
/// thread, which alone changes the variables; everything else by any thread, at any time. Writing
/// is wait-free; a reader that the writer overtakes by a whole ring is told.
class StateTable {
 public:
  /// Rows kept where nobody has said how many.
  static constexpr std::size_t kMinimumLength = 256;

  explicit StateTable(std::string name = "state");
  StateTable(const StateTable&) = delete;
  StateTable& operator=(const StateTable&) = delete;

  /// Makes `variable`, which must outlive the table, a column. Throws ConfigurationError when the
  /// name or the variable is a column already, or when rows have been written.
  template <FixedPayload T>
  void Add(const T& variable, std::string name) {
    AddColumn<T>(variable, std::move(name), {.bytes = kEncodedSize<T>, .is_dynamic = false});
  }
  /// The same for a dynamic type. A value of more than `capacity` bytes on the wire is left out of
  /// its row: readers are told that it is absent, and the column counts it.
  template <Payload T>
  requires(!FixedPayload<T>) void Add(const T& variable, std::string name, std::size_t capacity) {
    AddColumn<T>(variable, std::move(name), {.bytes = capacity, .is_dynamic = true});
  }

  /// How many rows can be read back at least. Throws ConfigurationError when it is 0, or when rows
  /// have been written.
  void SetLength(std::size_t rows);
  /// The rows of one second, at least kMinimumLength, at most what 16 MiB hold.
  [[nodiscard]] std::size_t LengthFor(std::chrono::nanoseconds period) const noexcept;
  /// Allocates the rows and touches their memory, so that the first cycle need not.
  void Prepare();
  /// Encodes every variable into a new row and makes that the newest. Allocates nothing after
  /// Prepare(), which it calls itself where nobody has.
  void Advance(SteadyTime now) noexcept;

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// As set; 0 before that.
  [[nodiscard]] std::size_t length() const noexcept { return length_; }
  /// Random; tells this table's ticks from those of an earlier one of the same name.
  [[nodiscard]] std::uint64_t epoch() const noexcept { return epoch_; }
  /// How many rows have been written: the newest has the tick before.
  [[nodiscard]] std::uint64_t next_tick() const noexcept { return rows_.next_tick(); }
  /// The oldest row that can still be read.
  [[nodiscard]] std::uint64_t oldest_tick() const noexcept { return rows_.oldest_tick(); }

  /// In the order they were added.
  [[nodiscard]] std::span<const std::unique_ptr<ColumnBase>> columns() const noexcept {
    return columns_;
  }
  /// The column of a name; null when there is none.
  [[nodiscard]] const ColumnBase* Find(std::string_view name) const noexcept;
  /// The column made from `variable`. Throws ConfigurationError when it is none.
  template <Payload T>
  [[nodiscard]] const Column<T>& Find(const T& variable) const {
    return static_cast<const Column<T>&>(Find(&variable, typeid(T)));
  }

  /// Copies all cells of a row; `words` has room for row_words(). The cells are what
  /// ColumnBase::Cell() gives. Never kAbsent or kInvalid.
  RowResult CopyRow(std::uint64_t tick, std::span<std::uint64_t> words,
                    std::int64_t& time_ns) const noexcept;
  /// The cells of one row, in words of 64 bits.
  [[nodiscard]] std::size_t row_words() const noexcept { return row_words_; }
  /// A column's CDR body in a row copied by CopyRow(); empty when its value was absent.
  [[nodiscard]] std::span<const std::byte> cell(std::span<const std::uint64_t> words,
                                                std::size_t column) const noexcept {
    return columns_[column]->Cell(words);
  }

 private:
  template <Payload T>
  void AddColumn(const T& variable, std::string name, CellLayout layout) {
    CheckColumn(name, &variable, typeid(T));
    layout.offset = row_words_;
    layout.words = (layout.bytes + 7) / 8 + (layout.is_dynamic ? 1 : 0);
    Append(std::make_unique<Column<T>>(rows_, variable, std::move(name), layout));
  }
  void RequireNoRows(std::string_view what) const;
  void CheckColumn(const std::string& name, const void* variable, const std::type_info& type) const;
  void Append(std::unique_ptr<ColumnBase> column);
  [[nodiscard]] const ColumnBase& Find(const void* variable, const std::type_info& type) const;

  std::string name_;
  std::uint64_t epoch_;
  std::size_t length_ = 0;
  std::size_t row_words_ = 0;
  std::vector<std::unique_ptr<ColumnBase>> columns_;
  std::vector<std::uint64_t> row_;  // where the writer encodes
  bool is_prepared_ = false;
  RowRing<> rows_;
};

}  // namespace tendon
