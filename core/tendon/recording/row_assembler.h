#pragma once

#include <tendon/recording/mcap/records.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tendon::recording {

/// Identifies a row of a table: the messages of one row have the same key.
struct RowKey {
  mcap::Timestamp time = 0;    ///< log time
  std::uint32_t sequence = 0;  ///< the low 32 bits of the tick
  std::uint64_t run = 0;       ///< a different number for each start of the source

  bool operator==(const RowKey&) const = default;
};

/// Returns how many rows are missing between two rows that follow each other. Returns 0 at the
/// start of a run, and if the sequence goes back, which happens only in damaged files.
[[nodiscard]] std::uint32_t MissingRowsBetween(const std::optional<RowKey>& before,
                                               const RowKey& next);

/// A row of a table.
struct AssembledRow {
  RowKey key;
  mcap::Timestamp publish_time = 0;                ///< that of the first message
  std::vector<std::optional<mcap::Buffer>> cells;  ///< CDR bodies; empty if there is no message
};

/// Joins messages into rows. A file has one message for each column of a row. The messages of a row
/// follow each other, but some may be missing. Events and other topics are rows with one column.
///
///     if (!rows.Accepts(column, key)) Use(rows.Take());
///     rows.Add(column, key, message);
///     ...
///     if (!rows.is_empty()) Use(rows.Take());  // at the end
///
/// The exports and the replay use it. Thread safety: one thread at a time.
class RowAssembler {
 public:
  explicit RowAssembler(std::size_t columns) { row_.cells.resize(columns); }

  [[nodiscard]] bool is_empty() const { return is_empty_; }
  /// Returns true if the message belongs to the present row, or if there is no present row.
  [[nodiscard]] bool Accepts(std::size_t column, const RowKey& key) const;
  /// Adds the cell of a message that was accepted. Copies its body.
  void Add(std::size_t column, const RowKey& key, const mcap::Message& message);
  void Add(std::size_t column, const RowKey& key, mcap::Timestamp publish_time, mcap::Buffer body);
  /// Removes and returns the present row.
  AssembledRow Take();

 private:
  using Cells = std::vector<std::optional<mcap::Buffer>>;

  AssembledRow row_;
  bool is_empty_ = true;
};

}  // namespace tendon::recording
