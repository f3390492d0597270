#include <gcm_console/output/recording_text.h>
#include <gcm_console/output/table.h>
#include <gcm_console/output/text.h>
#include <gcm_console/verbs/common_options.h>
#include <gcm_console/verbs/recording_part.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/base/os/termination.h>
#include <tendon/base/text.h>
#include <tendon/payload/codec.h>
#include <tendon/recording/csv_export.h>
#include <tendon/recording/hdf5/hdf5_export.h>
#include <tendon/recording/mcap/copy.h>
#include <tendon/recording/mcap/log_time_text.h>
#include <tendon/recording/mcap/reader.h>
#include <tendon/recording/mcap/verify.h>
#include <tendon/recording/recording_format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace console {
namespace {

using nlohmann::ordered_json;
constexpr double kSecond = 1e9;  // ns

namespace mcap = tendon::mcap;
namespace recording = tendon::recording;

/// Returns the number of lost rows that the recording reports, by the path of the table.
std::map<std::string, std::uint64_t> LossesIn(mcap::Reader& reader) {
  std::map<std::string, std::uint64_t> losses;
  mcap::Query query;
  for (const auto& [id, channel] : reader.channels()) {
    if (channel.topic == recording::kLossTopic) query.channels.push_back(id);
  }
  if (query.channels.empty()) return losses;
  mcap::MessageStream messages = reader.Messages(query);
  while (const auto message = messages.Next()) {
    recording::Loss loss;
    if (!tendon::Decode(recording::BodyOf(message->data), loss)) continue;
    losses[loss.path] += loss.table + loss.network + loss.recorder;
  }
  return losses;
}

/// One topic of a file. Channels of the same topic count as one.
struct TopicFigures {
  std::string topic;
  std::string type;
  std::optional<std::uint64_t> messages;  // empty: unknown
  std::uint64_t lost = 0;
};

std::vector<TopicFigures> TopicsOf(mcap::Reader& reader) {
  const auto losses = LossesIn(reader);
  std::map<std::string, TopicFigures> topics;
  for (const auto& [id, channel] : reader.channels()) {
    TopicFigures& one = topics[channel.topic];
    one.topic = channel.topic;
    const auto schema = reader.schemas().find(channel.schema_id);
    one.type = schema == reader.schemas().end() ? "-" : schema->second.name;
    const std::string path = ChannelPath(channel);
    const auto lost = losses.find(path.substr(0, path.rfind('.')));
    one.lost = lost == losses.end() ? 0 : lost->second;
    if (!reader.statistics()) continue;
    const auto& counts = reader.statistics()->channel_message_counts;
    const auto count = counts.find(id);
    if (counts.empty() && reader.statistics()->message_count > 0) continue;
    one.messages = one.messages.value_or(0) + (count == counts.end() ? 0 : count->second);
  }
  std::vector<TopicFigures> all;
  for (auto& [topic, figures] : topics) all.push_back(std::move(figures));
  return all;
}

/// The facts that a file contains about itself.
struct FileFigures {
  std::uint64_t bytes = 0;
  std::optional<std::pair<mcap::Timestamp, mcap::Timestamp>> times;
  std::vector<TopicFigures> topics;

  [[nodiscard]] double seconds() const {
    return times ? static_cast<double>(times->second - times->first) / kSecond : 0.0;
  }
  /// Returns the rate in messages per second; 0 if unknown.
  [[nodiscard]] double RateOf(const TopicFigures& topic) const {
    const double all = static_cast<double>(topic.messages.value_or(0));
    return seconds() > 0.0 && all > 1.0 ? all / seconds() : 0.0;
  }
};

ordered_json InfoJson(const mcap::Reader& reader, const FileFigures& figures,
                      const mcap::Problems& problems, bool is_checked) {
  ordered_json json = {{"file", reader.name()},
                       {"bytes", figures.bytes},
                       {"profile", reader.header().profile},
                       {"library", reader.header().library},
                       {"seconds", figures.seconds()},
                       {"is_complete", !reader.was_scanned()},
                       {"is_being_recorded", reader.is_being_written()},
                       {"is_checked", is_checked},
                       {"unknown_records", reader.unknown_records()}};
  if (figures.times) {
    json["begin_ns"] = figures.times->first;
    json["end_ns"] = figures.times->second;
  }
  json["topics"] = ordered_json::array();
  for (const TopicFigures& topic : figures.topics) {
    ordered_json one = {{"topic", topic.topic}, {"type", topic.type}, {"lost", topic.lost}};
    if (topic.messages) one["messages"] = *topic.messages;
    if (topic.messages) one["rate_hz"] = figures.RateOf(topic);
    json["topics"].push_back(std::move(one));
  }
  json["attachments"] = ordered_json::array();
  for (const auto& one : reader.attachments()) {
    json["attachments"].push_back({{"name", one.name}, {"bytes", one.data_size}});
  }
  json["problems"] = ProblemTexts(problems.first(), problems.count());
  return json;
}

void PrintFigures(const Context& context, const mcap::Reader& reader, const FileFigures& figures) {
  std::ostream& out = context.out();
  out << Plain(reader.name()) << ": " << SizeText(figures.bytes) << ", profile '"
      << Plain(reader.header().profile) << "', written by '" << Plain(reader.header().library)
      << "'\n";
  if (figures.times) {
    out << mcap::LogTimeText(figures.times->first) << " to "
        << mcap::LogTimeText(figures.times->second) << ", " << Fixed(figures.seconds(), 3)
        << " s\n";
  }
  Table table({"TOPIC", "TYPE", "MESSAGES", "RATE/Hz", "LOST"});
  for (const TopicFigures& topic : figures.topics) {
    table.Add({Plain(topic.topic), Plain(topic.type),
               topic.messages ? std::to_string(*topic.messages) : "-",
               topic.messages ? Fixed(figures.RateOf(topic), 1) : "-", std::to_string(topic.lost)});
  }
  context.Print(table);
}

struct InfoOptions {
  std::string file;
  bool checks = false;
};

/// Describes a file with problems and names the next step.
void PrintDamage(Context& context, const mcap::Reader& reader, bool is_checked) {
  const std::string file = Plain(reader.name());
  if (reader.is_being_written()) {
    context.err() << "gcm: " << file << " is still being recorded, so it has no index yet\n";
    return;
  }
  context.err() << "gcm: " << file
                << " is damaged; to copy everything that can be read into a new file: gcm recover "
                << file << '\n';
  if (is_checked) return;
  context.err() << "gcm: to find all the damage: gcm info " << file << " --check\n";
}

Result<ExitCode> ShowInfo(Context& context, const InfoOptions& options) {
  auto reader = mcap::Reader::Open(std::filesystem::path(options.file));
  if (!reader) return reader.error();
  std::optional<mcap::Verification> verification;
  if (options.checks) verification = mcap::Verify(**reader);
  std::error_code ignored;
  FileFigures figures{.bytes = std::filesystem::file_size(options.file, ignored),
                      .times = RecordingTimes(**reader),
                      .topics = TopicsOf(**reader)};
  // Reading the losses may have found more.
  const mcap::Problems& problems = verification ? verification->problems : (*reader)->problems();
  if (context.settings().json) {
    context.PrintJson(InfoJson(**reader, figures, problems, options.checks));
  } else {
    PrintFigures(context, **reader, figures);
  }
  const ExitCode code = PrintProblems(context, problems.first(), problems.count());
  if (problems.count() > 0) PrintDamage(context, **reader, options.checks);
  return code;
}

/// Prints what was copied into a new file.
ExitCode ReportCopy(Context& context, const std::string& file, const mcap::CopyReport& report) {
  if (context.settings().json) {
    context.PrintJson({{"file", file},
                       {"messages", report.messages},
                       {"attachments", report.attachments},
                       {"problems", ProblemTexts(report.problems, report.problem_count)}});
  } else {
    context.out() << Plain(file) << ": " << tendon::Counted(report.messages, "message", "messages")
                  << ", " << tendon::Counted(report.attachments, "attachment", "attachments")
                  << '\n';
  }
  return PrintProblems(context, report.problems, report.problem_count);
}

Result<ExitCode> RecoverFile(Context& context, const RecordingPart& options) {
  const std::filesystem::path from(options.file);
  const std::filesystem::path to =
      options.output.empty()
          ? from.parent_path() / (from.stem().string() + "-recovered" + from.extension().string())
          : std::filesystem::path(options.output);
  tendon::os::HoldTerminationSignals();  // so that an incomplete file is removed
  const auto report = mcap::Recover(from, to, {}, &IsInterrupted);
  if (!report) return FailureOf(context, report.error());
  const ExitCode code = ReportCopy(context, to.string(), *report);
  // A damaged file is normal for this verb. The verb fails only if no message could be copied.
  return report->messages > 0 ? program::kOk : code;
}

Result<ExitCode> CutFile(Context& context, const RecordingPart& options) {
  auto reader = mcap::Reader::Open(std::filesystem::path(options.file));
  if (!reader) return reader.error();
  auto query = PartQuery(**reader, options);
  if (!query) return query.error();
  query->order = mcap::Query::Order::kFile;
  tendon::os::HoldTerminationSignals();
  const auto report = mcap::Copy(**reader, *query, options.output, {}, &IsInterrupted);
  if (!report) return FailureOf(context, report.error());
  return ReportCopy(context, options.output, *report);
}

struct ExportOptions : RecordingPart {
  std::string hdf5;  // the file; or `output` is the folder for CSV
};

/// The results of an export.
struct ExportFigures {
  std::vector<std::string> files;
  recording::ExportReport report;
};

Result<ExportFigures> Export(mcap::Reader& reader, const mcap::Query& query,
                             const ExportOptions& options) {
  if (!options.hdf5.empty()) {
    const auto report = recording::ExportHdf5(reader, query, options.hdf5, &IsInterrupted);
    if (!report) return report.error();
    return ExportFigures{{options.hdf5}, *report};
  }
  const auto report = recording::ExportCsv(reader, query, options.output, &IsInterrupted);
  if (!report) return report.error();
  ExportFigures figures{{}, *report};
  for (const auto& file : report->files) figures.files.push_back(file.string());
  return figures;
}

ordered_json ExportJson(const ExportFigures& figures) {
  const recording::ExportReport& report = figures.report;
  ordered_json left_out = ordered_json::array();
  for (const auto& [reason, messages] : report.left_out) {
    left_out.push_back({{"messages", messages}, {"reason", reason}});
  }
  return {{"files", figures.files},
          {"rows", report.rows},
          {"lost", report.lost},
          {"events", report.events},
          {"commands", report.commands},
          {"log_records", report.log},
          {"other_messages", report.others},
          {"incomplete", report.incomplete},
          {"left_out", std::move(left_out)}};
}

void PrintExport(Context& context, const recording::ExportReport& report, bool is_hdf5) {
  context.err() << "gcm: " << tendon::Counted(report.rows, "row", "rows") << ", " << report.lost
                << " lost, " << tendon::Counted(report.events, "event", "events") << ", "
                << tendon::Counted(report.commands, "command", "commands") << ", "
                << tendon::Counted(report.log, "log record", "log records") << ", "
                << tendon::Counted(report.others, "message", "messages") << " of other topics\n";
  if (report.incomplete > 0 && is_hdf5) {
    context.err() << "gcm: " << tendon::Counted(report.incomplete, "entry is", "entries are")
                  << " left out, because a part of the file is missing or malformed\n";
  } else if (report.incomplete > 0) {
    context.err() << "gcm: " << tendon::Counted(report.incomplete, "entry has", "entries have")
                  << " empty cells, because a part of the file is missing or malformed\n";
  }
  constexpr std::size_t kMax = 8;  // lines
  std::size_t lines = 0;
  for (const auto& [reason, messages] : report.left_out) {
    if (lines++ == kMax) {
      context.err() << "gcm: more messages are left out, for "
                    << tendon::Counted(report.left_out.size() - kMax, "other reason",
                                       "other reasons")
                    << "; --json lists all reasons\n";
      return;
    }
    context.err() << "gcm: " << tendon::Counted(messages, "message is", "messages are")
                  << " left out: " << Plain(reason) << '\n';
  }
}

Result<ExitCode> ExportFile(Context& context, const ExportOptions& options) {
  if (options.output.empty() == options.hdf5.empty()) {
    return Error{ErrorCode::kInvalid, "give either --csv FOLDER or --hdf5 FILE.h5, but not both"};
  }
  auto reader = mcap::Reader::Open(std::filesystem::path(options.file));
  if (!reader) return reader.error();
  const auto query = PartQuery(**reader, options);
  if (!query) return query.error();
  tendon::os::HoldTerminationSignals();
  const auto figures = Export(**reader, *query, options);
  if (!figures) return FailureOf(context, figures.error());
  if (context.settings().json) {
    context.PrintJson(ExportJson(*figures));
  } else {
    for (const auto& file : figures->files) context.out() << Plain(file) << '\n';
  }
  PrintExport(context, figures->report, !options.hdf5.empty());
  return PrintProblems(context, (*reader)->problems().first(), (*reader)->problems().count());
}

Verb::Run PrepareInfo(CLI::App& app) {
  auto options = std::make_shared<InfoOptions>();
  AddRecordingFile(app, options->file);
  app.add_flag("--check", options->checks,
               "also read the whole file, and compare all checksums and counts");
  return [options](Context& context) { return ShowInfo(context, *options); };
}

Verb::Run PrepareRecover(CLI::App& app) {
  auto options = std::make_shared<RecordingPart>();
  AddRecordingFile(app, options->file);
  WithKind(
      app.add_option("-o,--output", options->output, "the new file (default: run-recovered.mcap)"),
      WordKind::kFile);
  return [options](Context& context) { return RecoverFile(context, *options); };
}

Verb::Run PrepareCut(CLI::App& app) {
  auto options = std::make_shared<RecordingPart>();
  AddRecordingFile(app, options->file);
  WithKind(app.add_option("-o,--output", options->output, "the new file"), WordKind::kFile)
      ->required();
  AddRecordingPart(app, *options);
  return [options](Context& context) { return CutFile(context, *options); };
}

Verb::Run PrepareExport(CLI::App& app) {
  auto options = std::make_shared<ExportOptions>();
  AddRecordingFile(app, options->file);
  WithKind(
      app.add_option("--csv", options->output,
                     "write CSV files into this folder, one file for each table, event and topic"),
      WordKind::kFile);
  WithKind(app.add_option("--hdf5", options->hdf5,
                          "write this HDF5 file, with one group for each table, event and topic"),
           WordKind::kFile);
  AddRecordingPart(app, *options);
  return [options](Context& context) { return ExportFile(context, *options); };
}

}  // namespace

std::vector<Verb> FileVerbs() {
  return {{"info",
           "show the content and the rates of a recording, and whether the recording is complete",
           &PrepareInfo,
           {"gcm info run.mcap", "gcm info run.mcap --check"}},
          {"recover",
           "copy everything that can be read from a damaged recording into a new file",
           &PrepareRecover,
           {"gcm recover run.mcap"}},
          {"cut",
           "copy a part of a recording into a new file",
           &PrepareCut,
           {"gcm cut run.mcap -o part.mcap --from 10s --to 12s --paths 'robot/arm/**'"}},
          {"export",
           "write a recording as CSV or HDF5",
           &PrepareExport,
           {"gcm export run.mcap --csv run", "gcm export run.mcap --csv run --paths robot/arm",
            "gcm export run.mcap --hdf5 run.h5"}}};
}

}  // namespace console
