#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/status.h>
#include <tendon/lockfree/counter.h>
#include <tendon/payload/codec.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/payload/schema.h>
#include <tendon/state/cell.h>
#include <tendon/state/row_ring.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <typeinfo>
#include <utility>

namespace tendon {

/// Identifies a row.
struct RowStamp {
  std::uint64_t tick = 0;
  SteadyTime time;

  bool operator==(const RowStamp&) const = default;
};

/// Converts the result of a read to the status of a real-time call.
constexpr Status ToStatus(RowResult result) noexcept {
  if (result == RowResult::kDone) return Status::kDone;
  return result == RowResult::kInvalid ? Status::kInvalid : Status::kNoSample;
}

/// The base class of all columns of a table. Immutable, except for the count of absent values.
class ColumnBase {
 public:
  ColumnBase(std::string name, const CellLayout& layout, const Schema& schema,
             const Fingerprint& fingerprint);
  virtual ~ColumnBase() = default;
  ColumnBase(const ColumnBase&) = delete;
  ColumnBase& operator=(const ColumnBase&) = delete;

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] const CellLayout& layout() const noexcept { return layout_; }
  [[nodiscard]] const Schema& schema() const noexcept { return schema_; }
  [[nodiscard]] const Fingerprint& fingerprint() const noexcept { return fingerprint_; }
  /// Number of values that did not fit into the column's capacity; their cells are absent.
  [[nodiscard]] std::uint64_t absent() const noexcept { return absent_.value(); }
  /// Returns the cell of this column in a row that StateTable::CopyRow() has copied. It is a CDR
  /// body, which is empty if the value is absent.
  [[nodiscard]] std::span<const std::byte> Cell(std::span<const std::uint64_t> row) const noexcept;

 private:
  friend class StateTable;

  /// Writes the variable's value into `body` and returns its size; 0 if it does not fit.
  virtual std::size_t EncodeVariable(std::span<std::byte> body) const noexcept = 0;
  [[nodiscard]] virtual const void* variable() const noexcept = 0;
  [[nodiscard]] virtual const std::type_info& type() const noexcept = 0;
  /// Encodes the variable into `cell` and returns the words that changed. Called in the writer's
  /// thread.
  std::span<const std::uint64_t> Encode(std::span<std::uint64_t> cell) noexcept;

  std::string name_;
  CellLayout layout_;
  Schema schema_;
  Fingerprint fingerprint_;
  Counter<> absent_;
};

/// The history of one variable.
///
/// Thread safety: any thread may read at any time. A read never returns a mixture of two rows.
/// Reads of a fixed type allocate nothing. Reads of a dynamic type allocate only when `value`, or
/// the thread's buffer for cells, grows.
///
/// If the result is not kDone, `value` is unchanged, except after kInvalid: then `value` is
/// unspecified. kInvalid means that the writer's variable held an invalid value, such as an enum
/// value without a name.
template <Payload T>
class Column final : public ColumnBase {
 public:
  Column(const RowRing<>& rows, const T& variable, std::string name, const CellLayout& layout)
      : ColumnBase(std::move(name), layout, SchemaOf<T>(), FingerprintOf<T>()),
        rows_(rows),
        variable_(variable) {}

  /// Reads the newest value. Returns kNoSample before the first row, or if the newest value did not
  /// fit into the column. Takes about 4 ns for 64 bytes. Wait-free unless the writer overwrites the
  /// whole ring during the read.
  Status ReadNewest(T& value) const noexcept {
    std::uint64_t tick = 0;
    return ReadNewestCell(value, tick, [](const Word* /*row*/) {});
  }
  /// Reads the newest value and the stamp of its row.
  Status ReadNewest(T& value, RowStamp& stamp) const noexcept {
    return ReadNewestCell(value, stamp.tick, [&](const Word* row) { stamp.time = TimeOf(row); });
  }

  /// Reads the value of one row.
  RowResult ReadAt(std::uint64_t tick, T& value) const noexcept {
    return ReadCellAt(tick, value, [](const Word* /*row*/) {});
  }

  /// Reads the value that is `rows` rows older than the newest; 0 is the newest row.
  RowResult ReadDelayed(std::size_t rows, T& value) const noexcept {
    const std::uint64_t next = rows_.next_tick();
    return rows < next ? ReadAt(next - 1 - rows, value) : RowResult::kNotYet;
  }

  /// Reads the value that was valid at `time`, which is in the newest row that is not later than
  /// `time`. Returns kNotYet if all rows are later, and kOvertaken if this row is lost. Uses a
  /// binary search.
  RowResult ReadAtTime(SteadyTime time, T& value) const noexcept {
    std::uint64_t tick = 0;
    const RowResult found = rows_.Find(time.time_since_epoch().count(), tick);
    return found == RowResult::kDone ? ReadAt(tick, value) : found;
  }

  /// Reads every row from `tick` on, in order, into `value`, and calls `visit(stamp, value)`.
  /// Returns the tick to continue with. `lost` counts the rows that could not be read.
  template <typename Visitor>
  std::uint64_t ReadSince(std::uint64_t tick, T& value, std::uint64_t& lost, Visitor visit) const {
    return ReadRange(tick, rows_.next_tick(), value, lost, visit);
  }

  /// Like ReadSince(), but stops before the row `end`, or at the first row that is not written yet.
  /// StateTable::FindRow() finds the ticks of a time span.
  template <typename Visitor>
  std::uint64_t ReadRange(std::uint64_t tick, std::uint64_t end, T& value, std::uint64_t& lost,
                          Visitor visit) const {
    end = std::max(tick, std::min(end, rows_.next_tick()));
    const std::uint64_t first = std::clamp(rows_.oldest_tick(), tick, end);
    lost += first - tick;
    for (tick = first; tick < end; ++tick) {
      RowStamp stamp{tick, {}};
      const auto note_time = [&](const Word* row) { stamp.time = TimeOf(row); };
      if (ReadCellAt(tick, value, note_time) == RowResult::kDone) {
        visit(std::as_const(stamp), std::as_const(value));
      } else {
        ++lost;
      }
    }
    return tick;
  }

 private:
  using Word = RowRing<>::Word;

  std::size_t EncodeVariable(std::span<std::byte> body) const noexcept override {
    return EncodeTo(variable_, body);
  }
  [[nodiscard]] const void* variable() const noexcept override { return &variable_; }
  [[nodiscard]] const std::type_info& type() const noexcept override { return typeid(T); }

  static SteadyTime TimeOf(const Word* row) noexcept {
    return SteadyTime(std::chrono::nanoseconds(RowRing<>::TimeOf(row)));
  }

  /// Reads one cell. `read` copies the cell from a row, and also calls `note` with the row. The
  /// copy is decoded only if all of it is from one row.
  template <typename Read, typename Note>
  RowResult ReadCell(T& value, Read read, Note note) const {
    CellCopy<T> copy(layout());
    const RowResult result = read([&](const Word* row) {
      copy.Load(row + layout().offset);
      note(row);
    });
    if (result != RowResult::kDone) return result;
    if (copy.is_absent()) return RowResult::kAbsent;
    return Decode(copy.body(), value) ? RowResult::kDone : RowResult::kInvalid;
  }

  template <typename Note>
  RowResult ReadCellAt(std::uint64_t tick, T& value, Note note) const {
    return ReadCell(
        value, [&](auto copy) { return rows_.Read(tick, copy); }, note);
  }

  template <typename Note>
  Status ReadNewestCell(T& value, std::uint64_t& tick, Note note) const {
    const auto newest = [&](auto copy) { return rows_.ReadNewest(tick, copy); };
    if constexpr (FixedPayload<T>) {
      if (LiesAsOnWire(value)) {  // then the copy always has a valid value
        return ToStatus(newest([&](const Word* row) {
          LoadCell<kEncodedSize<T>>(row + layout().offset, reinterpret_cast<std::byte*>(&value));
          note(row);
        }));
      }
    }
    return ToStatus(ReadCell(value, newest, note));
  }

  const RowRing<>& rows_;
  const T& variable_;
};

}  // namespace tendon
