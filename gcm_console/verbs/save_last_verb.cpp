#include <gcm_console/output/catalogue_json.h>
#include <gcm_console/output/recording_text.h>
#include <gcm_console/output/text.h>
#include <gcm_console/verbs/common_options.h>
#include <gcm_console/verbs/recording_part.h>
#include <gcm_console/verbs/verb.h>
#include <program/command_line.h>
#include <tendon/base/os/termination.h>
#include <tendon/base/text.h>
#include <tendon/recording/save_last.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace console {
namespace {

using nlohmann::ordered_json;
using tendon::recording::IsToldByProcess;
using tendon::recording::LossesOf;
using tendon::recording::SavedEvents;
using tendon::recording::SavedTable;
using tendon::recording::SaveLastReport;

struct SaveLastWords {
  double seconds = 0.0;
  std::vector<std::string> paths;
  std::string file;
  tendon::mcap::Compression compression = tendon::mcap::Compression::kZstd;
  bool has_no_log = false;
};

double SecondsOf(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

tendon::recording::SaveLastOptions SaveLastOptionsOf(const Context& context,
                                                     const SaveLastWords& words) {
  return {.patterns = words.paths,
          .files = {.file = words.file, .compression = words.compression},
          .last = TimeOf(words.seconds),
          .has_log = !words.has_no_log,
          .timeout = context.settings().timeout,
          .stop = &IsInterrupted};
}

/// Prints one line: "robot/arm/state: 29.98 s of 30 s, 29980 rows".
void PrintTable(Context& context, const SavedTable& table, double wanted) {
  const auto& [rows, lost, reach, failure] = table.past;
  context.out() << Plain(table.path) << ": ";
  if (failure && rows == 0) {
    context.out() << "nothing: " << Plain(failure->message) << '\n';
    return;
  }
  if (!failure || reach.count() > 0) {
    context.out() << Fixed(std::min(SecondsOf(reach), wanted), 2) << " s of " << Fixed(wanted, 0)
                  << " s, ";
  }
  context.out() << tendon::Counted(rows, "row", "rows");
  if (lost > 0) context.out() << ", " << lost << " lost";
  if (failure) context.out() << ", then nothing more: " << Plain(failure->message);
  context.out() << '\n';
}

void PrintEvents(Context& context, const SavedEvents& events) {
  const auto& [count, lost, failure] = events.past;
  context.out() << Plain(events.path) << ": " << tendon::Counted(count, "event", "events");
  if (lost > 0) context.out() << ", " << lost << " lost";
  if (failure) context.out() << ", then nothing more: " << Plain(failure->message);
  context.out() << '\n';
}

void PrintReport(Context& context, const SaveLastReport& report, double wanted) {
  for (const SavedTable& table : report.tables) PrintTable(context, table, wanted);
  for (const SavedEvents& events : report.events) {
    if (!IsToldByProcess(events, report)) PrintEvents(context, events);
  }
  context.err() << "gcm: " << tendon::Counted(report.counts.rows, "row", "rows") << ", "
                << tendon::Counted(report.counts.events, "event", "events") << " and "
                << tendon::Counted(report.counts.log, "log line", "log lines") << ", "
                << SizeText(report.counts.bytes) << " in " << Plain(report.file.string()) << '\n';
  for (const auto& process : report.processes) {
    const std::string reach = ReachText(process, TimeOf(wanted));
    if (reach.empty()) continue;
    context.err() << "gcm: " << Plain(process.process) << " reached back " << Plain(reach) << '\n';
  }
  for (const std::string& loss : LossesOf(report)) {
    context.err() << "gcm: " << Plain(loss) << '\n';
  }
}

/// Adds the losses and the failure of a reading.
template <typename Past>
ordered_json WithFlaws(ordered_json json, const Past& past) {
  json["lost"] = past.lost;
  if (past.failure) json["error"] = past.failure->message;
  return json;
}

void PrintJsonReport(Context& context, const SaveLastReport& report, double wanted) {
  ordered_json processes = ordered_json::array();
  for (const auto& process : report.processes) {
    ordered_json one = {{"process", process.process}};
    if (process.history) one["history"] = ToJson(*process.history);
    const std::string reach = ReachText(process, TimeOf(wanted));
    if (!reach.empty()) one["reached_back"] = reach;
    processes.push_back(std::move(one));
  }
  ordered_json tables = ordered_json::array();
  for (const auto& [path, past] : report.tables) {
    tables.push_back(WithFlaws(
        {{"path", path}, {"seconds", std::min(SecondsOf(past.reach), wanted)}, {"rows", past.rows}},
        past));
  }
  ordered_json events = ordered_json::array();
  for (const auto& [path, past] : report.events) {
    events.push_back(WithFlaws({{"path", path}, {"events", past.events}}, past));
  }
  context.PrintJson({{"file", report.file.string()},
                     {"seconds", wanted},
                     {"processes", std::move(processes)},
                     {"tables", std::move(tables)},
                     {"events", std::move(events)},
                     {"losses", LossesOf(report)},
                     {"rows", report.counts.rows},
                     {"event_count", report.counts.events},
                     {"log_records", report.counts.log},
                     {"bytes", report.counts.bytes}});
}

Result<ExitCode> SaveLastSeconds(Context& context, const SaveLastWords& words) {
  if (words.seconds <= 0.0) {
    return Error{ErrorCode::kInvalid, "the time must be above 0, such as: gcm save-last 30s ..."};
  }
  tendon::os::HoldTerminationSignals();  // so that an interrupted file is completed
  const auto queue = std::make_shared<tendon::recording::RecordingQueue>();
  const auto client = context.Client(queue);
  if (!client) return FailureOf(context, client.error());
  tendon::recording::GcmSystem system(**client, context.settings().timeout);
  const auto report = tendon::recording::SaveLast(system, queue, SaveLastOptionsOf(context, words));
  if (!report) return FailureOf(context, report.error());
  context.settings().json ? PrintJsonReport(context, *report, words.seconds)
                          : PrintReport(context, *report, words.seconds);
  if (report->is_stopped) {
    context.err() << "gcm: interrupted; " << Plain(report->file.string())
                  << " has only what was saved until then\n";
    return program::kInterrupted;
  }
  const bool is_whole =
      LossesOf(*report).empty() &&
      std::ranges::none_of(report->tables,
                           [](const SavedTable& one) { return one.past.failure.has_value(); }) &&
      std::ranges::none_of(report->events, [&](const SavedEvents& one) {
        return one.past.failure && !IsToldByProcess(one, *report);
      });
  return is_whole ? program::kOk : program::kPartial;
}

Verb::Run PrepareSaveLast(CLI::App& app) {
  auto words = std::make_shared<SaveLastWords>();
  app.add_option("time", words->seconds, "the time span to save, up to now: 30s, 500ms, 2min")
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformDuration, ""))
      ->required();
  WithKind(
      app.add_option("paths", words->paths,
                     "processes, components, interfaces or columns, or patterns with * and **"),
      WordKind::kPath)
      ->required();
  WithKind(app.add_option("-o,--output", words->file,
                          "the file, such as last.mcap; Ctrl+C completes it with the data that has "
                          "arrived, which takes up to about the time of --timeout if a process "
                          "does not answer"),
           WordKind::kFile)
      ->required();
  AddCompression(app, words->compression);
  app.add_flag("--no-log", words->has_no_log, "do not save the log of the processes");
  return [words](Context& context) { return SaveLastSeconds(context, *words); };
}

}  // namespace

std::vector<Verb> PastVerbs() {
  return {
      {"save-last",
       "save the last seconds of rows, events and log, which the processes keep, into an MCAP file",
       &PrepareSaveLast,
       {"gcm save-last 30s 'robot/**' -o last.mcap"}}};
}

}  // namespace console
