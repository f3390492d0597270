#include <gcm_console/output/recording_text.h>
#include <gcm_console/output/text.h>
#include <gcm_console/verbs/recording_part.h>
#include <gcm_console/verbs/verb.h>
#include <program/command_line.h>
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
  tendon::recording::SaveLastOptions options{
      .patterns = words.paths,
      .files = {.file = words.file, .compression = words.compression},
      .has_log = !words.has_no_log,
      .timeout = context.settings().timeout};
  options.last = std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::min(std::chrono::duration<double>(words.seconds),
               std::chrono::duration<double>(tendon::kLongestWait)));
  return options;
}

void PrintTable(Context& context, const SavedTable& table, double wanted) {
  context.out() << Plain(table.path) << ": ";
  if (table.failure) {
    context.out() << "nothing: " << Plain(table.failure->message) << '\n';
    return;
  }
  const double reach = std::min(SecondsOf(table.past.reach), wanted);
  context.out() << Fixed(reach, 2) << " s of " << Fixed(wanted, 0) << " s, "
                << tendon::Counted(table.past.rows, "row", "rows");
  if (table.past.lost > 0) context.out() << ", " << table.past.lost << " lost";
  context.out() << '\n';
}

void PrintReport(Context& context, const SaveLastReport& report, double wanted) {
  for (const SavedTable& table : report.tables) PrintTable(context, table, wanted);
  context.err() << "gcm: " << tendon::Counted(report.counts.rows, "row", "rows") << " and "
                << tendon::Counted(report.counts.log, "log line", "log lines") << ", "
                << SizeText(report.counts.bytes) << " in " << Plain(report.file.string()) << '\n';
  if (report.event_interfaces > 0) {
    context.err() << "gcm: the file has no events, because no program keeps past events\n";
  }
}

void PrintJsonReport(Context& context, const SaveLastReport& report, double wanted) {
  ordered_json tables = ordered_json::array();
  for (const SavedTable& table : report.tables) {
    ordered_json one = {{"path", table.path},
                        {"seconds", std::min(SecondsOf(table.past.reach), wanted)},
                        {"rows", table.past.rows},
                        {"lost", table.past.lost}};
    if (table.failure) one["error"] = table.failure->message;
    tables.push_back(std::move(one));
  }
  context.PrintJson({{"file", report.file.string()},
                     {"seconds", wanted},
                     {"tables", std::move(tables)},
                     {"rows", report.counts.rows},
                     {"log_records", report.counts.log},
                     {"bytes", report.counts.bytes}});
}

Result<ExitCode> SaveLastSeconds(Context& context, const SaveLastWords& words) {
  if (words.seconds <= 0.0) {
    return Error{ErrorCode::kInvalid, "the time must be above 0, such as: gcm save-last 30s ..."};
  }
  const auto queue = std::make_shared<tendon::recording::RecordingQueue>();
  const auto client = context.Client(queue);
  if (!client) return client.error();
  tendon::recording::GcmSystem system(**client, context.settings().timeout);
  const auto report = tendon::recording::SaveLast(system, queue, SaveLastOptionsOf(context, words));
  if (!report) return report.error();
  context.settings().json ? PrintJsonReport(context, *report, words.seconds)
                          : PrintReport(context, *report, words.seconds);
  const bool is_whole = std::ranges::none_of(
      report->tables, [](const SavedTable& table) { return table.failure.has_value(); });
  return is_whole ? program::kOk : program::kPartial;
}

Verb::Run PrepareSaveLast(CLI::App& app) {
  auto words = std::make_shared<SaveLastWords>();
  app.add_option("time", words->seconds, "the time span to save, up to now: 30s, 500ms, 2min")
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformDuration, ""))
      ->required();
  WithKind(app.add_option(
               "paths", words->paths,
               "processes, components, interfaces or columns, also as patterns with * and **"),
           WordKind::kPath)
      ->required();
  WithKind(app.add_option("-o,--output", words->file, "the file, such as last.mcap"),
           WordKind::kFile)
      ->required();
  AddCompression(app, words->compression);
  app.add_flag("--no-log", words->has_no_log, "do not save the log of the processes");
  return [words](Context& context) { return SaveLastSeconds(context, *words); };
}

}  // namespace

std::vector<Verb> PastVerbs() {
  return {{"save-last",
           "save the past rows and log records that the system still keeps into an MCAP file",
           &PrepareSaveLast,
           {"gcm save-last 30s 'robot/**' -o last.mcap"}}};
}

}  // namespace console
