#pragma once

#include <tendon/base/clock.h>
#include <tendon/process/process.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/recording_reader.h>
#include <tendon/recording/replayed_component.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tendon::recording {

/// How a recording is played.
struct ReplayOptions {
  double rate = 1.0;   ///< 2: twice as fast as recorded
  bool loops = false;  ///< begins again at the end
  std::string as;      ///< the name of the process; empty: as recorded
  /// The time between the first Play() and the first row, in which other programs can connect and
  /// subscribe.
  std::chrono::nanoseconds delay{0};
};

/// The progress of a replay.
struct ReplayStatus {
  std::uint64_t rows = 0;
  std::uint64_t events = 0;
  std::uint64_t commands = 0;            ///< calls
  std::uint64_t log = 0;                 ///< records
  std::uint64_t passes = 0;              ///< number of passes that have ended
  std::uint64_t log_left_out = 0;        ///< records of processes that are not replayed
  std::chrono::nanoseconds extended{0};  ///< delay of the replay, because it was too slow
};

/// Plays a recording in a running system: each recorded process appears as a process with the
/// recorded components. They have the state tables, events and commands of the original components,
/// so that other components can connect and subscribe to them as usual. Commands are refused (see
/// ReplayedComponent); observers of commands see the recorded calls. The log is sent again, too.
///
/// Rows have the recorded ticks and values. The time between two rows is the difference of their
/// log times, divided by the rate. If a replay is too slow, it takes longer, but leaves nothing
/// out.
///
///     auto replay = Replay::Open(std::move(reader), query, {.rate = 2.0});
///     (*replay)->Start(make_process);
///     while (const auto next = (*replay)->Play(SteadyClock().Now())) SleepUntil(*next);
///     while (!(*replay)->HasSentAll()) SleepALittle();
///
/// Thread safety: one thread at a time.
class Replay {
 public:
  /// Makes a process with this name, which joins the GCM.
  using MakeProcess = std::function<Result<std::unique_ptr<Process>>(const std::string& name)>;

  /// Reads the part once. Fails like RecordingReader::Open(). Also fails with kInvalid if the
  /// options name one process but the part has several, if the tables of the part need more than 1
  /// GiB, or if the replay would take more than ten years.
  static Result<std::unique_ptr<Replay>> Open(std::unique_ptr<mcap::Reader> reader,
                                              mcap::Query part, ReplayOptions options);
  Replay(const Replay&) = delete;
  Replay& operator=(const Replay&) = delete;
  /// Ends the processes.
  ~Replay();

  /// The names of the processes. Before Start(), the names that they will have.
  [[nodiscard]] std::vector<std::string> processes() const;
  /// The counts of the part.
  [[nodiscard]] const RecordedCounts& contained() const { return items_->counts(); }
  [[nodiscard]] const mcap::Reader& reader() const { return *reader_; }

  /// Makes and starts the processes with their components. After an error, no process exists.
  Result<void> Start(const MakeProcess& make);
  /// Fails like Process::WaitUntilJoined().
  Result<void> WaitUntilJoined(std::chrono::milliseconds timeout) const;

  /// Writes the rows and raises the events that are due at `now`, at most about a thousand. Returns
  /// the time of the next call, or nothing at the end. Must be called after Start().
  std::optional<SteadyTime> Play(SteadyTime now);

  /// True if all rows and events from Play() were sent to all viewers and clients. Must be called
  /// after Start(). See Process::HasSentAll().
  [[nodiscard]] bool HasSentAll() const;

  [[nodiscard]] ReplayStatus status() const { return status_; }

 private:
  Replay(std::unique_ptr<mcap::Reader> reader, std::unique_ptr<RecordingReader> items,
         ReplayOptions options);

  [[nodiscard]] Result<void> CheckSize() const;
  Result<void> AddComponents(const std::string& recorded, Process& process);
  [[nodiscard]] std::vector<std::string> recorded_processes() const;
  [[nodiscard]] std::string NameOf(const std::string& recorded) const;
  [[nodiscard]] std::chrono::nanoseconds PeriodOf(const RecordedSource& source) const;
  [[nodiscard]] SteadyTime DueTime(mcap::Timestamp time) const;
  void Put(const RecordedItem& item);
  void PutLog(const RosLog& record);

  const std::unique_ptr<mcap::Reader> reader_;
  const std::unique_ptr<RecordingReader> items_;
  const ReplayOptions options_;
  std::vector<std::shared_ptr<ReplayedMembers>> members_;      // by source
  std::map<std::string, std::unique_ptr<Process>> processes_;  // by recorded name

  std::optional<RecordedItem> next_;
  std::optional<SteadyTime> begin_;  // start of this pass
  mcap::Timestamp last_time_ = 0;    // time of the latest item
  ReplayStatus status_;
};

}  // namespace tendon::recording
