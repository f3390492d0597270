#pragma once

#include <tendon/base/result.h>
#include <tendon/recording/recorded_system.h>
#include <tendon/recording/recording_queue.h>
#include <tendon/recording/recording_writer.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tendon::recording {

/// What SaveLast() saves, and where.
struct SaveLastOptions {
  std::vector<std::string> patterns;
  FileOptions files;                 ///< one file: without a split
  std::chrono::nanoseconds last{0};  ///< how far back
  bool has_log = true;
  /// The longest time for the rows of one table, and for the log.
  std::chrono::milliseconds timeout{2000};
};

/// How much of one table was saved.
struct SavedTable {
  std::string path;
  PastRows past;
  std::optional<Error> failure;  ///< why not all of its rows could be read
};

/// What SaveLast() has saved.
struct SaveLastReport {
  std::vector<SavedTable> tables;
  std::uint64_t event_interfaces = 0;  ///< that fit a pattern; their past events exist nowhere
  Counts counts;
  Losses losses;
  std::filesystem::path file;
};

/// Writes what the running system still remembers of the last seconds into a new file: the rows
/// that the processes hold in their state tables, the log records that the GCM has kept, and the
/// catalogue of now. A table holds about a second, unless its component keeps more. Events are kept
/// nowhere.
///
/// `queue` is the listener of `system`. Waits until all is written: up to the timeout for each
/// table and for the log. kNotFound if no table fits a pattern; kFailed if the process of a
/// LocalSystem is busy, so that its tables are not known; kExists if there is a file of this name.
/// If a table cannot be read, its entry in the report says why, and the others are saved. Must not
/// be called in a handler.
Result<SaveLastReport> SaveLast(RecordedSystem& system,
                                const std::shared_ptr<RecordingQueue>& queue,
                                SaveLastOptions options);

}  // namespace tendon::recording
