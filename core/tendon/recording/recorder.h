#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/client.h>
#include <tendon/recording/condition.h>
#include <tendon/recording/pre_trigger_buffer.h>
#include <tendon/recording/recorded_system.h>
#include <tendon/recording/recording_queue.h>
#include <tendon/recording/recording_writer.h>
#include <tendon/recording/trigger.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace tendon::recording {

struct RecorderOptions {
  std::vector<std::string> patterns{};  ///< the paths to record, such as "robot/**"
  FileOptions files{};
  bool has_log = true;
  /// Writes nothing before this condition is true; then the file is created.
  std::optional<Condition> start_when{};
  /// The recording ends when this condition becomes true after the recording has started.
  std::optional<Condition> stop_when{};
  /// The recording begins this long before `start_when` becomes true.
  std::chrono::nanoseconds before{0};
  /// The recording ends this long after `stop_when` becomes true.
  std::chrono::nanoseconds after{0};
  /// The maximum memory for the entries that arrive before `start_when` becomes true. At least one
  /// entry is kept.
  std::size_t before_bytes = std::size_t{256} << 20U;
  /// The time limit of a request to a process.
  std::chrono::milliseconds timeout{2000};
};

/// The state of a recording, as a window or a terminal shows it.
struct RecorderStatus {
  Counts counts;
  Losses losses;
  std::size_t tables = 0;         ///< number of recorded tables
  std::size_t interfaces = 0;     ///< number of interfaces whose events or commands are recorded
  std::size_t waiting_bytes = 0;  ///< bytes in the queue, which wait for the disk
  std::uint64_t disk_free = 0;    ///< free bytes of the disk
  std::filesystem::path file;     ///< the file that is being written
  std::optional<Error> failure;   ///< the reason why the recording has stopped
  bool is_waiting = false;        ///< waits for the condition to start; there is no file yet
  bool is_finished = false;       ///< the condition to stop was true; call Recorder::Stop()
  /// While the recorder waits: the memory of the entries that it keeps, in bytes.
  std::size_t before_bytes = 0;
  /// The number of rows that arrived before the start and did not fit into
  /// RecorderOptions::before_bytes. `losses` contains them as losses of the recorder.
  std::uint64_t before_rows_missing = 0;
  /// The same number for events, calls and log records.
  std::uint64_t before_others_missing = 0;
};

/// Records a running system into MCAP files, until Stop() or an error: all rows of the chosen
/// tables, the chosen events and commands, the log, and all changes of the catalogue. Processes may
/// come and go; tables and interfaces that appear later are also recorded if they match a pattern.
/// If the GCM ends, the recording continues, because rows and events come directly from the
/// processes.
///
/// With a condition to start, the recorder receives data from the moment it is created. When the
/// condition becomes true, it writes only entries that are not older than RecorderOptions::before.
/// Both conditions are evaluated for every row, event and call.
///
/// If the disk is slow, the recording loses rows, which are counted; components are never delayed.
/// If the disk fails, everything that is not in the file counts as lost. The file is synced every
/// 0.8 s, so at most 1 s is lost if this program is killed.
///
/// Two threads: one follows the catalogue and subscribes, the other one writes.
///
///     const auto queue = std::make_shared<recording::RecordingQueue>();
///     GcmClient client(middleware, options, queue);
///     auto recorder = recording::Recorder::Start(client, queue, {.patterns = {"robot/**"}, ...});
///     ...
///     (*recorder)->Stop();
///
/// Thread safety: all functions, from any thread except handlers of the client. The client must
/// outlive it.
class Recorder {
 public:
  /// `queue` is the client's listener. Fails with kExists if there is a file with this name, and
  /// like Trigger::Make() if a condition is wrong.
  static Result<std::unique_ptr<Recorder>> Start(GcmClient& client,
                                                 std::shared_ptr<RecordingQueue> queue,
                                                 RecorderOptions options);
  /// The same for any system, such as a LocalSystem, whose listener is `queue`.
  static Result<std::unique_ptr<Recorder>> Start(std::shared_ptr<RecordedSystem> system,
                                                 std::shared_ptr<RecordingQueue> queue,
                                                 RecorderOptions options);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  /// Calls Stop() and ignores its result.
  ~Recorder();

  /// Ends all subscriptions, writes all entries that have arrived, and completes the file. Returns
  /// the reason if the recording had already stopped, or if the file cannot be completed. A second
  /// call returns the same result.
  Result<void> Stop();

  [[nodiscard]] RecorderStatus status() const;
  /// Sentences about interruptions since the last call.
  std::vector<std::string> TakeNotices();

 private:
  struct Table {
    TableSubscription subscription;
    TelemetryClient::Id id = 0;
  };
  struct Listener {
    EventSubscription subscription;
    std::vector<Fingerprint> types;
    GcmClient::ListenerId id = 0;
  };
  /// The events of an interface, or its commands. The two have separate subscriptions, because a
  /// Source has only one of the two.
  struct ListenerKey {
    InterfaceName interface;
    bool are_commands = false;
    auto operator<=>(const ListenerKey&) const = default;
  };

  struct Triggers {
    std::unique_ptr<Trigger> start;
    std::unique_ptr<Trigger> stop;
  };

  Recorder(std::shared_ptr<RecordedSystem> system, std::shared_ptr<RecordingQueue> queue,
           RecorderOptions options, Triggers triggers, std::unique_ptr<RecordingWriter> writer);

  void Follow();
  void FollowOnce(bool may_wait);
  void NoteGoneProcesses(const Catalogue& catalogue);
  [[nodiscard]] bool IsEnded(const Catalogue& catalogue, const std::string& process) const;
  void FollowTables(const std::vector<TableSubscription>& wanted, const Catalogue& catalogue);
  /// Follows events and commands. Returns false if some of them are left out, because their types
  /// must be requested first.
  bool FollowEvents(const std::vector<EventSubscription>& wanted, const Catalogue& catalogue,
                    bool may_wait);
  std::map<Fingerprint, Schema> TypesOf(const Catalogue& catalogue, const EventSubscription& events,
                                        const std::vector<Fingerprint>& types);
  [[nodiscard]] bool IsStopping() const;
  void EndSubscriptions();

  void WriteUntilStopped();
  Result<void> WriteSome();
  Result<void> Write(RecordingEntry entry);
  Result<void> WriteOrNotice(const RecordingEntry& entry);
  Result<void> StartIfDue();
  Result<void> Begin(SteadyTime start);
  void KeepLosses();
  [[nodiscard]] Losses LossesUntil(SteadyTime time) const;
  void StopIfDue(SteadyTime now);
  [[nodiscard]] Losses LossesBeforeWriting() const;
  [[nodiscard]] Losses LossesOfRecording() const;
  void PublishStatus();

  const std::shared_ptr<RecordedSystem> system_;
  const std::shared_ptr<RecordingQueue> queue_;
  const RecorderOptions options_;

  std::mutex stop_mutex_;  // one Stop() at a time
  std::optional<Result<void>> stopped_;

  // Used by the thread that follows the catalogue, and after its end by Stop().
  std::map<InterfaceName, Table> tables_;
  std::map<ListenerKey, Listener> listeners_;
  std::map<Fingerprint, Schema> types_;
  std::uint64_t revision_ = 0;
  std::uint64_t snapshots_ = 0;   // see RecordingQueue::snapshots()
  std::set<std::string> gone_;    // processes that were lost or had left
  std::set<std::string> silent_;  // processes that did not answer since the last change
  bool has_all_events_ = false;

  // Used by the thread that writes, and after its end by Stop().
  std::unique_ptr<RecordingWriter> writer_;  // null before the start, or if no file can be created
  bool is_waiting_;                          // waits for the condition to start
  SteadyTime next_sync_;
  Triggers triggers_;
  PreTriggerBuffer past_;
  std::deque<std::pair<SteadyTime, Losses>> kept_losses_;  // while it waits, by time
  SteadyTime armed_;                                       // the time when it began to wait
  SteadyTime started_ = SteadyTime::min();                 // the time when the condition was true
  SteadyTime from_ = SteadyTime::min();                    // the recording begins at this time
  SteadyTime to_ = SteadyTime::max();                      // the recording ends at this time

  mutable std::mutex mutex_;
  std::condition_variable stop_;
  bool follows_ = true;
  bool is_drained_ = false;  // nothing more will arrive
  RecorderStatus status_;
  Losses losses_before_;   // losses before the start of the recording
  Losses missing_before_;  // see RecorderStatus::before_rows_missing
  Losses unwritten_;       // entries that have arrived and are not in the file
  std::set<std::string> refused_paths_;
  std::vector<std::string> notices_;

  std::thread following_thread_;
  std::thread writing_thread_;
};

}  // namespace tendon::recording
