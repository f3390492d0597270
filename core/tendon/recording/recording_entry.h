#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/payload/schema.h>
#include <tendon/process/log/log_messages.h>
#include <tendon/process/telemetry_client.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

/// The entries that a recorder receives from a running system. In LostRows, `viewer` counts the
/// rows that the recorder itself has lost, because the disk was slower than the data, or failed.
namespace tendon::recording {

/// A column of a table, an event, or a command with the type of its calls.
struct EntryMember {
  std::string name;
  Schema schema;
};

/// A table, or the events or the commands of an interface, with its present types. After each
/// recovery of the connection, there is a new object.
struct EntrySource {
  InterfaceName name;
  std::vector<EntryMember> members;
  bool are_commands = false;
};

/// Consecutive rows of a table.
struct RowsEntry {
  std::shared_ptr<const EntrySource> source;
  std::uint64_t epoch = 0;                        ///< as in RowBatch
  std::chrono::nanoseconds clock_offset{0};       ///< likewise
  std::chrono::nanoseconds clock_uncertainty{0};  ///< likewise
  LostRows lost_before;                           ///< rows that were lost just before these rows
  std::vector<std::uint64_t> ticks;
  std::vector<std::int64_t> times;        ///< on the clock of the source, ns
  std::vector<std::uint32_t> cell_sizes;  ///< bytes, row by row
  std::vector<std::byte> cells;           ///< CDR bodies, row by row
};

/// An event that was raised, or a call of a command.
struct EventEntry {
  std::shared_ptr<const EntrySource> source;
  std::size_t member = 0;
  SteadyTime raised;             ///< for a call, the end of its execution
  std::vector<std::byte> value;  ///< a CDR body; empty if there is no argument
};

/// A record of the log of a process.
struct LogEntry {
  message::LogRecord record;
};

/// The whole catalogue, or the next changes of it.
struct CatalogueEntry {
  bool is_snapshot = false;
  SteadyTime received;
  std::vector<CatalogueChange> changes;
};

using RecordingEntry = std::variant<RowsEntry, EventEntry, LogEntry, CatalogueEntry>;

/// Returns the memory of an entry, in bytes.
[[nodiscard]] std::size_t SizeOf(const RecordingEntry& entry);
[[nodiscard]] std::size_t SizeOf(const RowsEntry& rows);
[[nodiscard]] std::size_t SizeOf(const EventEntry& event);
[[nodiscard]] std::size_t SizeOf(const LogEntry& entry);
[[nodiscard]] std::size_t SizeOf(const CatalogueEntry& changes);
/// Returns the path of the table or event; empty for a log record and for changes of the catalogue.
[[nodiscard]] std::string PathOf(const RecordingEntry& entry);

/// All losses of a recording up to now, by the path of the table, event or command.
struct Losses {
  std::map<std::string, LostRows> rows;
  std::map<std::string, std::uint64_t> events;  ///< events, and calls of commands
  std::uint64_t log = 0;                        ///< records

  /// Sums over all paths.
  [[nodiscard]] LostRows all_rows() const;
  [[nodiscard]] std::uint64_t all_events() const;
  /// Returns the number of all lost rows, events and log records.
  [[nodiscard]] std::uint64_t all() const { return all_rows().all() + all_events() + log; }
  Losses& operator+=(const Losses& other);
  /// Counts an entry as lost by the recorder, because it was not written. The first `written` rows
  /// were written and do not count.
  void AddUnwritten(const RecordingEntry& entry, std::uint64_t written = 0);
};

}  // namespace tendon::recording
