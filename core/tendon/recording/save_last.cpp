#include <tendon/recording/save_last.h>

#include <tendon/base/text.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/text.h>
#include <tendon/recording/recording_selection.h>

#include <algorithm>
#include <deque>
#include <future>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <type_traits>
#include <utility>

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;

Error SentNothing(const std::string& sender, std::chrono::milliseconds timeout) {
  return {ErrorCode::kTimeout,
          sender + " sent nothing for " + std::to_string(timeout.count()) + " ms"};
}

Error Stopped() { return {ErrorCode::kFailed, "the saving was interrupted"}; }

/// Saves the history of a system into one file.
class PastWriter {
 public:
  PastWriter(RecordedSystem& system, std::shared_ptr<RecordingQueue> queue, RecordingWriter& writer,
             const SaveLastOptions& options)
      : system_(system), queue_(std::move(queue)), writer_(writer), options_(options) {}

  Result<message::ProcessHistoryState> GetHistory(const std::string& process) {
    if (auto reason = WhyNotRead(process)) return *std::move(reason);
    auto history = system_.GetProcessHistory(process);
    if (!history && history.error().code == ErrorCode::kTimeout) Skip(process, history.error());
    return history;
  }

  Result<SavedTable> SaveTable(const TableSubscription& table) {
    auto past = Read<PastRows>(table.process, [&](auto done) {
      system_.telemetry().ReadPast(table, options_.last, queue_->SinkOf(table), done);
    });
    if (!past) return past.error();
    return SavedTable{ToString(InterfaceName{table.process, table.component, table.table}),
                      *std::move(past)};
  }

  Result<SavedEvents> SaveEvents(const EventSubscription& events, const Catalogue& catalogue) {
    auto sink = queue_->SinkOf(events, TypesOf(events, catalogue));
    auto past = Read<PastEvents>(events.provided.process, [&](auto done) {
      system_.ReadPastEvents(events, options_.last, std::move(sink), done);
    });
    if (!past) return past.error();
    return SavedEvents{ToString(events.provided), *std::move(past)};
  }

  /// Reads the log that the process has kept itself. If the process does not send all of it,
  /// returns the reason. In this case, the missing records are taken from the GCM, as far as it has
  /// them.
  std::optional<Error> ReadLog(const std::string& process) {
    constexpr int kMaxPages = 1024;  // 128 MiB, if the process is not malicious
    std::vector<ReceivedLog>& received = received_log_[process];
    message::ReadLog wanted{.last = options_.last};
    std::uint64_t end = 0;
    for (int pages = 0; pages < kMaxPages; ++pages) {
      if (auto reason = WhyNotRead(process)) return reason;
      auto page = system_.ReadLog(process, wanted);
      if (!page) return page.error();
      if (pages == 0) end = page->end;
      // The process may have dropped records after the previous page.
      if (received.empty() || page->since > received.back().until) {
        received.push_back({page->since, page->since});
      }
      for (message::LogRecord& record : page->records) {
        received.back().until = std::max(received.back().until, record.time);
        record.process = process;
        log_.push_back(std::move(record));
      }
      if (page->next >= end) {
        received.back().until = std::numeric_limits<std::int64_t>::max();
        return {};
      }
      if (page->next <= wanted.first) break;
      wanted.first = page->next;
    }
    return Error{ErrorCode::kInvalid, "process '" + process + "' sent a log that does not end"};
  }

  /// Writes the log records of all processes, including records that only the GCM has, sorted by
  /// time. If the GCM has not sent all of its records, returns the reason.
  Result<std::optional<Error>> SaveLog() {
    const auto has_all = WriteUntil([this] { return queue_->has_past_log(); }, options_.timeout);
    if (!has_all) return has_all.error();
    std::erase_if(log_of_gcm_, [this](const message::LogRecord& record) {
      return std::ranges::any_of(received_log_[record.process], [&](const ReceivedLog& received) {
        return record.time > received.since && record.time <= received.until;
      });
    });
    if (auto written = WriteLog(); !written) return written.error();
    if (*has_all) return std::optional<Error>();
    return std::optional(is_stopped_ ? Stopped() : SentNothing("the GCM", options_.timeout));
  }

  /// Saves the tables, the events and, if it is wanted, the log of the report's processes.
  Result<void> SaveAll(const RecordingSelection& selection, const Catalogue& catalogue,
                       SaveLastReport& report) {
    for (const TableSubscription& table : selection.tables) {
      auto saved = SaveTable(table);
      if (!saved) return saved.error();
      report.tables.push_back(*std::move(saved));
    }
    for (const EventSubscription& events : selection.events) {
      auto saved = SaveEvents(events, catalogue);
      if (!saved) return saved.error();
      report.events.push_back(*std::move(saved));
    }
    if (!options_.has_log) return {};
    for (SavedProcess& saved : report.processes) saved.log_failure = ReadLog(saved.process);
    auto failure = SaveLog();
    if (!failure) return failure.error();
    report.log_failure = *std::move(failure);
    return {};
  }

  /// Passes all entries that have arrived to the writer, which counts the entries that it cannot
  /// write.
  void WriteRest() {
    while (queue_->waiting_bytes() > 0) (void)WriteSome(0ms);
    (void)WriteLog();
  }

  /// Returns true if SaveLastOptions::stop has ended the reading.
  [[nodiscard]] bool is_stopped() const { return is_stopped_; }

 private:
  /// The time span, in ns since 1970, for which a process has sent all its log records.
  struct ReceivedLog {
    std::int64_t since = 0;  // a record of this time may be missing
    std::int64_t until = 0;
  };

  [[nodiscard]] bool IsStopped() {
    is_stopped_ = is_stopped_ || (options_.stop && options_.stop());
    return is_stopped_;
  }
  /// Returns the reason why nothing more is read from this process; empty if there is none.
  [[nodiscard]] std::optional<Error> WhyNotRead(const std::string& process) {
    if (IsStopped()) return Stopped();
    const auto skipped = skipped_.find(process);
    return skipped == skipped_.end() ? std::nullopt : std::optional(skipped->second);
  }
  /// Nothing more is read from this process, because each request would take as long as the first
  /// one.
  void Skip(const std::string& process, const Error& reason) { skipped_.emplace(process, reason); }

  /// Calls `begin(done)`, and waits for the end of this reading. If it ends with kTimeout, or if
  /// nothing arrives for longer than a reading may take to end by itself, the result contains this
  /// failure, and the process is skipped from now on.
  template <typename Past, typename Begin>
  Result<Past> Read(const std::string& process, Begin begin) {
    const Counts before = writer_.counts();
    if (!WhyNotRead(process)) {
      // Opening a link, measuring the clock, and the reply.
      const std::chrono::milliseconds longest = 3 * options_.timeout + 1s;
      const auto promise = std::make_shared<std::promise<Past>>();
      std::future<Past> arrival = promise->get_future();
      begin([promise](const Past& past) { promise->set_value(past); });
      const auto is_there =
          WriteUntil([&] { return arrival.wait_for(0s) == std::future_status::ready; }, longest);
      if (!is_there) return is_there.error();
      if (*is_there) {
        Past past = arrival.get();
        if (past.failure && past.failure->code == ErrorCode::kTimeout) Skip(process, *past.failure);
        return past;
      }
      if (!is_stopped_) {
        Skip(process, SentNothing("process '" + process + "'", longest));
      } else if (const auto written = WriteSome(0ms); !written) {  // what has arrived
        return written.error();
      }
    }
    Past part;  // how far it reaches back is not known
    if constexpr (std::is_same_v<Past, PastRows>) {
      part.rows = writer_.counts().rows - before.rows;
    } else {
      part.events = writer_.counts().events - before.events;
    }
    part.failure = WhyNotRead(process);
    return part;
  }

  /// Writes what has arrived until a condition is true. Returns false if nothing more arrives for
  /// `timeout`, or if the reading is stopped.
  template <typename Predicate>
  Result<bool> WriteUntil(Predicate done, std::chrono::milliseconds timeout) {
    SteadyTime deadline = SteadyClock().Now() + timeout;
    while (!IsStopped()) {
      const bool is_done = done();
      const bool is_late = !is_done && SteadyClock().Now() >= deadline;
      const auto written = WriteSome(is_done || is_late ? 0ms : 10ms);
      if (!written) return written.error();
      if (*written > 0) deadline = SteadyClock().Now() + timeout;
      if ((is_done || is_late) && queue_->waiting_bytes() == 0) return is_done;
    }
    return false;
  }

  /// Returns the number of entries that have arrived. Continues after a failure. Log records are
  /// not written yet, because SaveLog() needs all of them.
  Result<std::size_t> WriteSome(std::chrono::nanoseconds timeout) {
    const std::deque<RecordingEntry> entries = queue_->Take(timeout);
    Result<void> result;
    for (const RecordingEntry& entry : entries) {
      if (const auto* record = std::get_if<LogEntry>(&entry)) {
        log_of_gcm_.push_back(record->record);
      } else if (auto written = Write(entry); !written) {
        result = written;
      }
    }
    if (!result) return result.error();
    return entries.size();
  }

  /// Writes the log records that have arrived, by time. Continues after a failure.
  Result<void> WriteLog() {
    std::vector<message::LogRecord> records = std::exchange(log_, {});
    std::ranges::move(std::exchange(log_of_gcm_, {}), std::back_inserter(records));
    std::ranges::stable_sort(records, {}, &message::LogRecord::time);
    Result<void> result;
    for (message::LogRecord& record : records) {
      if (auto written = Write(LogEntry{std::move(record)}); !written) result = written;
    }
    return result;
  }

  /// An entry that the file cannot hold is not a failure, because the writer counts it as lost.
  Result<void> Write(const RecordingEntry& entry) {
    auto written = writer_.Write(entry);
    if (!written && written.error().code == ErrorCode::kInvalid) return {};
    return written;
  }

  /// Returns the types of the events. A type is missing if the process does not return it; its
  /// events are then lost. If the process does not answer, it is skipped from now on.
  std::map<Fingerprint, Schema> TypesOf(const EventSubscription& events,
                                        const Catalogue& catalogue) {
    std::map<Fingerprint, Schema> types;
    const ProvidedDescription* provided = catalogue.FindProvided(events.provided);
    const std::string& process = events.provided.process;
    if (provided == nullptr) return types;
    for (const MemberDescription& event : provided->events) {
      const Fingerprint type = event.signature.in;
      if (!TakesArgument(event.signature) || types.contains(type)) continue;
      if (WhyNotRead(process)) break;
      const auto schema = system_.FindSchema(process, type);
      if (schema) {
        types.emplace(type, *schema);
      } else if (schema.error().code == ErrorCode::kTimeout) {
        Skip(process, schema.error());
      }
    }
    return types;
  }

  RecordedSystem& system_;
  const std::shared_ptr<RecordingQueue> queue_;
  RecordingWriter& writer_;
  const SaveLastOptions& options_;
  std::vector<message::LogRecord> log_;         // records that the processes have kept
  std::vector<message::LogRecord> log_of_gcm_;  // records that the GCM has sent
  std::map<std::string, std::vector<ReceivedLog>> received_log_;  // by process
  std::map<std::string, Error> skipped_;                          // processes that do not answer
  bool is_stopped_ = false;
};

}  // namespace

std::string ReachText(const SavedProcess& process, std::chrono::nanoseconds wanted) {
  if (process.history) return HistoryReachText(*process.history, wanted);
  return "not known: " + process.failure.message;
}

bool IsToldByProcess(const SavedEvents& events, const SaveLastReport& report) {
  return events.past.failure && std::ranges::any_of(report.processes, [&](const auto& process) {
           const bool has_none = process.history && process.history->limit == 0;
           return has_none && events.path.starts_with(process.process + "/");
         });
}

std::vector<std::string> LossesOf(const SaveLastReport& report) {
  std::vector<std::string> all;
  for (const SavedProcess& process : report.processes) {
    const bool has_log = process.history && process.history->limit > 0;  // ReachText() tells others
    if (!has_log || !process.log_failure) continue;
    all.push_back(process.process +
                  ": its log could not be read completely: " + process.log_failure->message);
  }
  const auto add = [&all](const std::string& what) {
    all.push_back(what + " sent, but not written into the file");
  };
  for (const auto& [path, lost] : report.losses.rows) {
    const std::uint64_t unwritten = lost.network + lost.viewer;  // PastRows::lost has the others
    if (unwritten > 0) add(path + ": " + Counted(unwritten, "row", "rows"));
  }
  for (const auto& [path, lost] : report.losses.events) {
    if (lost > 0) add(path + ": " + Counted(lost, "event", "events"));
  }
  if (report.log_failure) {
    all.push_back("the log of the GCM could not be read completely: " +
                  report.log_failure->message);
  }
  if (report.losses.log > 0) add(Counted(report.losses.log, "log record", "log records"));
  return all;
}

std::vector<std::string> ShortfallsOf(const SaveLastReport& report,
                                      std::chrono::nanoseconds wanted) {
  std::vector<std::string> all;
  for (const SavedProcess& process : report.processes) {
    const std::string reach = ReachText(process, wanted);
    if (!reach.empty()) all.push_back(process.process + ": " + reach);
  }
  for (const auto& [path, past] : report.tables) {
    if (past.lost > 0) all.push_back(path + ": " + Counted(past.lost, "row", "rows") + " lost");
    if (past.failure) all.push_back(path + ": " + past.failure->message);
  }
  for (const SavedEvents& events : report.events) {
    const auto& [path, past] = events;
    if (past.lost > 0) all.push_back(path + ": " + Counted(past.lost, "event", "events") + " lost");
    if (past.failure && !IsToldByProcess(events, report)) {
      all.push_back(path + ": " + past.failure->message);
    }
  }
  std::ranges::move(LossesOf(report), std::back_inserter(all));
  return all;
}

Result<SaveLastReport> SaveLast(RecordedSystem& system,
                                const std::shared_ptr<RecordingQueue>& queue,
                                SaveLastOptions options) {
  if (auto unknown = system.WhyUnknown()) return *std::move(unknown);
  const Catalogue catalogue = system.catalogue();
  const RecordingSelection selection = Select(catalogue, options.patterns);
  if (selection.tables.empty() && selection.events.empty()) {
    return Error{ErrorCode::kNotFound, "no state table and no event matches these paths"};
  }
  options.files.past = options.last;
  auto writer = RecordingWriter::Create(options.files, HeadingFor(catalogue, options.patterns));
  if (!writer) return writer.error();
  if (options.has_log) system.WatchLog();
  SaveLastReport report{.file = (*writer)->file()};
  std::set<std::string> processes;
  for (const TableSubscription& table : selection.tables) processes.insert(table.process);
  for (const EventSubscription& events : selection.events)
    processes.insert(events.provided.process);
  PastWriter past_writer(system, queue, **writer, options);
  for (const std::string& process : processes) {
    const auto history = past_writer.GetHistory(process);
    SavedProcess& saved = report.processes.emplace_back();
    saved.process = process;
    if (history) saved.history = *history;
    if (!history) saved.failure = history.error();
  }
  if (auto saved = past_writer.SaveAll(selection, catalogue, report); !saved) {
    past_writer.WriteRest();
    queue->Close();
    auto closed =
        (*writer)->Close(queue->losses());  // its error says whether the file has an index
    return closed ? saved.error() : closed.error();
  }
  report.losses = queue->losses();
  queue->Close();
  if (auto closed = (*writer)->Close(report.losses); !closed) return closed.error();
  report.losses += (*writer)->losses();
  report.counts = (*writer)->counts();
  report.is_stopped = past_writer.is_stopped();
  if (report.is_stopped && report.counts.rows + report.counts.events + report.counts.log == 0) {
    std::error_code ignored;
    std::filesystem::remove(report.file, ignored);
    return Error{ErrorCode::kFailed,
                 "the saving was interrupted before anything was read; no file was written"};
  }
  return report;
}

}  // namespace tendon::recording
