#include <tendon/recording/save_last.h>
#include <tendon/recording/selection.h>

#include <future>
#include <utility>

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;

/// Writes what has arrived in the queue until a condition is true.
class QueueWriter {
 public:
  QueueWriter(RecordingQueue& queue, RecordingWriter& writer) : queue_(queue), writer_(writer) {}

  /// Returns false if `done` was not true within `patience`.
  template <typename Predicate>
  Result<bool> WriteUntil(Predicate done, std::chrono::milliseconds patience) {
    const SteadyTime deadline = SteadyClock().Now() + patience;
    while (true) {
      const bool is_done = done();
      const bool is_late = !is_done && SteadyClock().Now() >= deadline;
      if (auto written = WriteSome(is_done || is_late ? 0ms : 10ms); !written) {
        return written.error();
      }
      if ((is_done || is_late) && queue_.waiting_bytes() == 0) return is_done;
    }
  }

 private:
  /// Goes on after a failure and if the file cannot hold an entry: the writer counts the losses.
  Result<void> WriteSome(std::chrono::nanoseconds patience) {
    Result<void> result;
    for (const Entry& entry : queue_.Take(patience)) {
      auto written = writer_.Write(entry);
      if (!written && written.error().code != ErrorCode::kInvalid) result = written;
    }
    return result;
  }

  RecordingQueue& queue_;
  RecordingWriter& writer_;
};

Result<SavedTable> SaveTable(RecordedSystem& system, const std::shared_ptr<RecordingQueue>& queue,
                             QueueWriter& writer, const TableSubscription& table,
                             const SaveLastOptions& options) {
  SavedTable saved{.path = ToString(InterfaceName{table.process, table.component, table.table}),
                   .past = {},
                   .failure = {}};
  const auto answer = std::make_shared<std::promise<Result<PastRows>>>();
  auto arrival = answer->get_future();
  system.telemetry().ReadPast(table, options.last, queue->SinkOf(table),
                              [answer](Result<PastRows> past) { answer->set_value(past); });
  const auto is_there = writer.WriteUntil(
      [&] { return arrival.wait_for(0s) == std::future_status::ready; }, options.timeout);
  if (!is_there) return is_there.error();
  if (!*is_there) {
    saved.failure = Error{ErrorCode::kTimeout, "process '" + table.process + "' sent no rows in " +
                                                   std::to_string(options.timeout.count()) + " ms"};
    return saved;
  }
  const Result<PastRows> past = arrival.get();
  if (past) saved.past = *past;
  if (!past) saved.failure = past.error();
  return saved;
}

}  // namespace

Result<SaveLastReport> SaveLast(RecordedSystem& system,
                                const std::shared_ptr<RecordingQueue>& queue,
                                SaveLastOptions options) {
  if (auto unknown = system.WhyUnknown()) return *std::move(unknown);
  const Catalogue catalogue = system.catalogue();
  const Selection selection = Select(catalogue, options.patterns);
  if (selection.tables.empty()) {
    return Error{ErrorCode::kNotFound, "no state table matches these paths"};
  }
  options.files.past = options.last;
  auto writer = RecordingWriter::Create(options.files, HeadingFor(catalogue, options.patterns));
  if (!writer) return writer.error();
  if (options.has_log) system.WatchLog();
  SaveLastReport report{.tables = {},
                        .event_interfaces = selection.events.size(),
                        .counts = {},
                        .losses = {},
                        .file = (*writer)->file()};
  QueueWriter queue_writer(*queue, **writer);
  const auto close_after = [&](const Error& failure) {
    while (queue->waiting_bytes() > 0) (void)queue_writer.WriteUntil([] { return true; }, 0ms);
    queue->Close();
    auto closed = (*writer)->Close(queue->losses());
    return closed ? failure : closed.error();  // that also says whether the file has an index
  };
  for (const TableSubscription& table : selection.tables) {
    auto saved = SaveTable(system, queue, queue_writer, table, options);
    if (!saved) return close_after(saved.error());
    report.tables.push_back(*std::move(saved));
  }
  const auto has_log = queue_writer.WriteUntil(
      [&] { return !options.has_log || queue->has_past_log(); }, options.timeout);
  if (!has_log) return close_after(has_log.error());
  report.losses = queue->losses();
  queue->Close();
  if (auto closed = (*writer)->Close(report.losses); !closed) return closed.error();
  report.losses += (*writer)->losses();
  report.counts = (*writer)->counts();
  return report;
}

}  // namespace tendon::recording
