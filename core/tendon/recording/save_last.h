#pragma once

#include <tendon/base/os/part_file.h>
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

/// The data that SaveLast() saves, and the file.
struct SaveLastOptions {
  std::vector<std::string> patterns{};
  FileOptions files{};               ///< one file: without a split
  std::chrono::nanoseconds last{0};  ///< how far back
  bool has_log = true;
  /// The timeout of the client of `system`. The GCM must send its log within this time, and no
  /// reading waits longer than three times this time and a second for the next rows or events.
  std::chrono::milliseconds timeout{2000};
  os::StopRequest stop{};  ///< after it has returned true, nothing more is read
};

/// The part of one table that was saved.
struct SavedTable {
  std::string path;
  PastRows past;
};
/// The events of one interface that were saved.
struct SavedEvents {
  std::string path;
  PastEvents past;
};

/// The history of a process when the saving began.
struct SavedProcess {
  std::string process;
  std::optional<message::ProcessHistoryState> history{};
  Error failure{};                     ///< the reason if `history` is empty
  std::optional<Error> log_failure{};  ///< the reason why not all of its log could be read
};
/// Returns the time span of the saved history, and why it is not longer, for example "12.3 s: it
/// has not been running longer". Returns an empty string if all of `wanted` could be saved.
[[nodiscard]] std::string ReachText(const SavedProcess& process, std::chrono::nanoseconds wanted);

/// The report about the saved data.
struct SaveLastReport {
  std::vector<SavedTable> tables{};
  std::vector<SavedEvents> events{};
  std::vector<SavedProcess> processes{};
  std::optional<Error> log_failure{};  ///< the reason why not all log records of the GCM were read
  bool is_stopped = false;  ///< SaveLastOptions::stop has returned true: the file has only a part
  Counts counts{};
  Losses losses{};
  std::filesystem::path file;
};

/// Returns true if the events could not be saved because their process keeps no history;
/// ReachText() contains this reason.
[[nodiscard]] bool IsToldByProcess(const SavedEvents& events, const SaveLastReport& report);
/// Returns a sentence for each log that could not be read completely, also that of the GCM, and for
/// each table, event and log with entries that were sent, but are not in the file.
[[nodiscard]] std::vector<std::string> LossesOf(const SaveLastReport& report);
/// Returns the sentences of LossesOf(), and a sentence for each process whose history is shorter
/// than `wanted`, and for each table and interface that could not be saved completely.
[[nodiscard]] std::vector<std::string> ShortfallsOf(const SaveLastReport& report,
                                                    std::chrono::nanoseconds wanted);

/// Writes the kept history of the running system into a new file: the rows, events and log records
/// that the processes have kept (process/history), the log records that only the GCM has, and the
/// present catalogue. If a process keeps no history, only the rows in its state tables are saved,
/// which is about the last second.
///
/// `queue` is the listener of `system`. Waits until everything is written. If a process does not
/// answer a request in time, nothing more is read from this process. If a table or the events of an
/// interface cannot be read completely, the reason is in their entry of the report, and the other
/// data is saved. The same holds for everything that is not read because of `options.stop`; if
/// nothing was read, no file remains, and the result is kFailed. Fails with kNotFound if no table
/// and no event matches a pattern, with kFailed if the process of a LocalSystem is busy, so that
/// its tables are unknown, and with kExists if there is a file with this name. Must not be called
/// in a handler.
Result<SaveLastReport> SaveLast(RecordedSystem& system,
                                const std::shared_ptr<RecordingQueue>& queue,
                                SaveLastOptions options);

}  // namespace tendon::recording
