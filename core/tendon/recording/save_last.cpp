#include <tendon/recording/recorder.h>
#include <tendon/recording/save_last.h>

#include <future>
#include <utility>

namespace tendon::recording {
namespace {

using namespace std::chrono_literals;

/// Writes what has arrived in the inbox until a condition is true.
class InboxWriter {
 public:
  InboxWriter(Inbox& inbox, Files& files) : inbox_(inbox), files_(files) {}

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
      if ((is_done || is_late) && inbox_.waiting_bytes() == 0) return is_done;
    }
  }

 private:
  Result<void> WriteSome(std::chrono::nanoseconds patience) {
    for (const Entry& entry : inbox_.Take(patience)) {
      if (auto written = files_.Write(entry); !written) return written;
    }
    return {};
  }

  Inbox& inbox_;
  Files& files_;
};

Result<SavedTable> SaveTable(SystemAccess& system, const std::shared_ptr<Inbox>& inbox,
                             InboxWriter& writer, const TableSubscription& table,
                             const SaveLastOptions& options) {
  SavedTable saved{.path = ToString(InterfaceName{table.process, table.component, table.table}),
                   .past = {},
                   .failure = {}};
  const auto answer = std::make_shared<std::promise<Result<PastRows>>>();
  auto arrival = answer->get_future();
  system.telemetry().ReadPast(table, options.last, inbox->SinkOf(table),
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

Result<SaveLastReport> SaveLast(SystemAccess& system, const std::shared_ptr<Inbox>& inbox,
                                SaveLastOptions options) {
  if (auto unknown = system.WhyUnknown()) return *std::move(unknown);
  const Catalogue catalogue = system.catalogue();
  const Choice choice = Choose(catalogue, options.patterns);
  if (choice.tables.empty()) {
    return Error{ErrorCode::kNotFound, "no state table matches these paths"};
  }
  options.files.past = options.last;
  auto files = Files::Create(options.files, HeadingFor(catalogue, options.patterns));
  if (!files) return files.error();
  if (options.has_log) system.WatchLog();
  SaveLastReport report{.tables = {},
                        .event_interfaces = choice.events.size(),
                        .counts = {},
                        .losses = {},
                        .file = (*files)->file()};
  InboxWriter writer(*inbox, **files);
  for (const TableSubscription& table : choice.tables) {
    auto saved = SaveTable(system, inbox, writer, table, options);
    if (!saved) return saved.error();
    report.tables.push_back(*std::move(saved));
  }
  const auto has_log =
      writer.WriteUntil([&] { return !options.has_log || inbox->has_past_log(); }, options.timeout);
  if (!has_log) return has_log.error();
  report.losses = inbox->losses();
  inbox->Close();
  if (auto closed = (*files)->Close(report.losses); !closed) return closed.error();
  report.counts = (*files)->counts();
  return report;
}

}  // namespace tendon::recording
