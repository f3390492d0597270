#include <gcm_console/output/recording_text.h>
#include <gcm_console/output/table.h>
#include <gcm_console/output/text.h>
#include <gcm_console/verbs/common_options.h>
#include <gcm_console/verbs/recording_part.h>
#include <gcm_console/verbs/verb.h>
#include <program/command_line.h>
#include <tendon/base/os/termination.h>
#include <tendon/base/text.h>
#include <tendon/recording/recorder.h>
#include <tendon/recording/recording_selection.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace console {
namespace {

using namespace std::chrono_literals;
using nlohmann::ordered_json;
using tendon::recording::Recorder;
using tendon::recording::RecorderStatus;
using Elapsed = std::chrono::duration<double>;

struct RecordOptions {
  std::vector<std::string> paths;
  std::string file;
  double delay = 0.0;            // s
  double seconds = 0.0;          // 0: no end
  std::uint64_t split_size = 0;  // bytes; 0: no limit
  double split_seconds = 0.0;    // 0: no limit
  std::uint64_t keep = 0;        // number of files; 0: keep all
  tendon::mcap::Compression compression = tendon::mcap::Compression::kZstd;
  std::string start_when;                                  // empty: start at once
  std::string stop_when;                                   // empty: stop only for other reasons
  double before = 0.0;                                     // s
  double after = 0.0;                                      // s
  std::uint64_t before_bytes = std::uint64_t{256} << 20U;  // the memory for data before the start
  bool has_no_log = false;
  bool ends_with_link = false;
};

tendon::recording::RecorderOptions RecorderOptionsOf(const Context& context,
                                                     const RecordOptions& options) {
  tendon::recording::RecorderOptions all{
      .patterns = options.paths,
      .files = {.file = options.file, .split_size = options.split_size, .keep = options.keep},
      .has_log = !options.has_no_log,
      .timeout = context.settings().timeout};
  all.files.compression = options.compression;
  all.files.split_time = TimeOf(options.split_seconds);
  all.before = TimeOf(options.before);
  all.after = TimeOf(options.after);
  all.before_bytes = options.before_bytes;
  return all;
}

/// Adds the conditions for start and stop. Returns kInvalid if a condition cannot be parsed, or if
/// an option is given without an option that it needs.
Result<tendon::recording::RecorderOptions> WithConditions(tendon::recording::RecorderOptions all,
                                                          const RecordOptions& options) {
  if (options.keep > 0 && options.split_size == 0 && options.split_seconds == 0.0) {
    return Error{ErrorCode::kInvalid, "--keep needs --split-size or --split-time"};
  }
  if (options.before > 0.0 && options.start_when.empty()) {
    return Error{ErrorCode::kInvalid, "--before needs --start-when"};
  }
  if (options.after > 0.0 && options.stop_when.empty()) {
    return Error{ErrorCode::kInvalid, "--after needs --stop-when"};
  }
  const auto read = [](const std::string& text, auto& condition) -> Result<void> {
    if (text.empty()) return {};
    auto parsed = tendon::recording::ParseCondition(text);
    if (!parsed) return parsed.error();
    condition = *std::move(parsed);
    return {};
  };
  if (auto start = read(options.start_when, all.start_when); !start) return start.error();
  if (auto stop = read(options.stop_when, all.stop_when); !stop) return stop.error();
  return all;
}

/// Prints the state of a recording: each second on a terminal and as JSON, and at its end.
class RecordingPrinter {
 public:
  explicit RecordingPrinter(Context& context) : context_(context) {}

  void PrintBegin(const RecorderStatus& status, const RecordOptions& options) {
    if (status.is_waiting) {
      context_.err() << "gcm: waiting for " << Plain(options.start_when);
      if (options.before > 0.0) {
        context_.err() << "; the recorder keeps the last " << Fixed(options.before, 1)
                       << " s, at most " << SizeText(options.before_bytes);
      }
      context_.err() << '\n';
    }
    context_.err() << (status.is_waiting ? "gcm: then records " : "gcm: recording ")
                   << tendon::Counted(status.tables, "table", "tables")
                   << " and the events and commands of "
                   << tendon::Counted(status.interfaces, "interface", "interfaces") << " into "
                   << Plain(status.file.string()) << '\n';
  }
  void PrintProgress(const RecorderStatus& status, Elapsed passed) {
    if (context_.settings().json) return PrintJson(status, passed, false);
    if (!context_.has_screen()) return;
    if (status.is_waiting) {
      context_.err() << "\r\033[Kwaiting; " << SizeText(status.before_bytes) << " kept"
                     << std::flush;
      is_line_open_ = true;
      return;
    }
    const double rate = (static_cast<double>(status.counts.bytes) - bytes_) /
                        std::max(1e-3, (passed - last_).count());
    bytes_ = static_cast<double>(status.counts.bytes);
    last_ = passed;
    context_.err() << "\r\033[K" << Fixed(passed.count(), 0) << " s: " << Held(status) << ", "
                   << SizeText(static_cast<std::uint64_t>(std::max(0.0, rate))) << "/s, "
                   << SizeText(status.disk_free) << " free, " << status.losses.all_rows().all()
                   << " lost" << std::flush;
    is_line_open_ = true;
  }
  /// Called when the condition to start has become true.
  void PrintStart(const RecorderStatus& status) {
    EndLine();
    context_.err() << "gcm: the condition is true: recording into " << Plain(status.file.string())
                   << '\n';
    if (status.before_rows_missing + status.before_others_missing == 0) return;
    context_.err() << "gcm: " << tendon::Counted(status.before_rows_missing, "row", "rows")
                   << " and " << status.before_others_missing
                   << " other entries before the condition was true are missing, because "
                      "--before-memory is too small\n";
  }
  void PrintNotices(const std::vector<std::string>& notices) {
    EndLine();
    PrintSentences(notices, context_.err());
  }
  void PrintEnd(const RecorderStatus& status, Elapsed passed) {
    EndLine();
    if (context_.settings().json) PrintJson(status, passed, true);
    if (status.failure) return;  // the error message says what the file contains
    if (status.is_waiting) {
      context_.err() << "gcm: the condition was never true; there is no recording\n";
      return;
    }
    const auto lost = status.losses.all_rows();
    context_.err() << "gcm: " << Held(status) << " in " << Fixed(passed.count(), 1) << " s in "
                   << Plain(status.file.string()) << "; " << lost.all() << " rows lost";
    if (lost.all() > 0) {
      context_.err() << " (" << lost.table << " in the table, " << lost.network
                     << " on the network, " << lost.viewer << " here)";
    }
    context_.err() << ", " << status.losses.all_events() << " events and commands lost\n";
  }
  void EndLine() {
    if (std::exchange(is_line_open_, false)) context_.err() << '\n';
  }

 private:
  static std::string Held(const RecorderStatus& status) {
    return tendon::Counted(status.counts.rows, "row", "rows") + ", " +
           tendon::Counted(status.counts.events, "event", "events") + ", " +
           tendon::Counted(status.counts.commands, "command", "commands") + ", " +
           SizeText(status.counts.bytes);
  }
  void PrintJson(const RecorderStatus& status, Elapsed passed, bool is_end) {
    const auto lost = status.losses.all_rows();
    context_.PrintJsonLine({{"seconds", passed.count()},
                            {"file", status.file.string()},
                            {"files", status.counts.files},
                            {"tables", status.tables},
                            {"rows", status.counts.rows},
                            {"events", status.counts.events},
                            {"commands", status.counts.commands},
                            {"log_records", status.counts.log},
                            {"bytes", status.counts.bytes},
                            {"free_bytes", status.disk_free},
                            {"lost_table", lost.table},
                            {"lost_network", lost.network},
                            {"lost_recorder", lost.viewer},
                            {"lost_events", status.losses.all_events()},
                            {"waiting", status.is_waiting},
                            {"before_bytes", status.before_bytes},
                            {"before_rows_missing", status.before_rows_missing},
                            {"before_others_missing", status.before_others_missing},
                            {"end", is_end}});
    context_.out().flush();
  }

  Context& context_;
  double bytes_ = 0.0;
  Elapsed last_{0.0};
  bool is_line_open_ = false;
};

/// Prints the patterns that match nothing yet, because a pattern may be misspelt.
void PrintUnmatched(Context& context, const tendon::Catalogue& catalogue,
                    const std::vector<std::string>& patterns) {
  for (const std::string& pattern : patterns) {
    if (!tendon::recording::Select(catalogue, {pattern}).is_empty()) continue;
    context.err() << "gcm: no table, event or command matches '" << Plain(pattern)
                  << "' now; objects that match later are recorded\n";
  }
}

/// Records until one of these occurs: a signal, the condition to stop, the end of the time, an
/// error, or (with --no-reconnect) the loss of the GCM. The time starts when the recording starts.
Result<ExitCode> RecordUntilDone(RecordingPrinter& printer, Recorder& recorder,
                                 tendon::recording::RecordingQueue& queue,
                                 const RecordOptions& options) {
  auto begin = std::chrono::steady_clock::now();
  const auto passed = [&] { return Elapsed(std::chrono::steady_clock::now() - begin); };
  auto next = begin + 1s;
  bool is_interrupted = false;
  bool is_broken = false;
  bool is_over = false;
  bool is_waiting = recorder.status().is_waiting;
  while (!is_interrupted && !is_broken && !is_over) {
    is_interrupted = tendon::os::TerminationRequested(20ms);
    const RecorderStatus status = recorder.status();
    is_broken = status.failure || (options.ends_with_link && queue.is_gcm_lost());
    if (is_waiting && !status.is_waiting) {
      is_waiting = false;
      begin = std::chrono::steady_clock::now();
      printer.PrintStart(status);
    }
    const bool is_late = !is_waiting && options.seconds > 0.0 && passed().count() > options.seconds;
    is_over = status.is_finished || is_late;
    if (auto notices = recorder.TakeNotices(); !notices.empty()) printer.PrintNotices(notices);
    if (std::chrono::steady_clock::now() < next) continue;
    next += 1s;
    printer.PrintProgress(status, is_waiting ? Elapsed(0) : passed());
  }
  const bool is_link_lost = options.ends_with_link && queue.is_gcm_lost();
  const auto recorded = recorder.Stop();
  if (auto notices = recorder.TakeNotices(); !notices.empty()) printer.PrintNotices(notices);
  printer.PrintEnd(recorder.status(), is_waiting ? Elapsed(0) : passed());
  if (!recorded) return recorded.error();
  if (is_link_lost)
    return Error{ErrorCode::kUnreachable,
                 "the GCM was lost, so the recording has ended; without "
                 "--no-reconnect, gcm waits for the GCM"};
  return is_interrupted ? program::kInterrupted : program::kOk;
}

Result<ExitCode> Record(Context& context, const RecordOptions& options) {
  auto recorder_options = WithConditions(RecorderOptionsOf(context, options), options);
  if (!recorder_options) return recorder_options.error();
  tendon::os::HoldTerminationSignals();
  const auto queue = std::make_shared<tendon::recording::RecordingQueue>();
  const auto client = context.Client(queue);
  if (!client) return client.error();
  const auto until = std::chrono::steady_clock::now() + TimeOf(options.delay);
  while (std::chrono::steady_clock::now() < until) {
    if (tendon::os::TerminationRequested(20ms)) return program::kInterrupted;
  }
  auto recorder = Recorder::Start(**client, queue, *std::move(recorder_options));
  if (!recorder) return recorder.error();
  RecordingPrinter printer(context);
  printer.PrintBegin((*recorder)->status(), options);
  PrintUnmatched(context, (*client)->catalogue(), options.paths);
  return RecordUntilDone(printer, **recorder, *queue, options);
}

Verb::Run PrepareRecord(CLI::App& app) {
  auto options = std::make_shared<RecordOptions>();
  WithKind(app.add_option("paths", options->paths,
                          "processes, components, interfaces, columns, events or commands, or "
                          "patterns with * and **; objects that appear later are recorded, too"),
           WordKind::kPath)
      ->required();
  WithKind(app.add_option("-o,--output", options->file, "the file, such as run.mcap"),
           WordKind::kFile)
      ->required();
  AddDuration(app, options->seconds);
  app.add_option("--delay", options->delay, "begin to record after this time: 10s, 500ms, 2min")
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformDuration, ""));
  app.add_option("--split-size", options->split_size,
                 "begin another file at this size: 500MB, 2GB; the files are run-1.mcap, ...")
      ->type_name("SIZE")
      ->transform(CLI::AsSizeValue(true));
  app.add_option("--split-time", options->split_seconds, "begin another file after this time")
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformDuration, ""));
  app.add_option("--keep", options->keep,
                 "with --split-size or --split-time: keep only this many of the newest files")
      ->transform(CLI::Validator(&program::TransformCount, ""));
  app.add_option("--start-when", options->start_when,
                 "write nothing until this event is raised or this command is executed, or until "
                 "this condition on a state table is true: robot/arm/Control.GoalReached, "
                 "'robot/arm/state.Joints.position[2] > 1.2 rad'; a condition compares a column by "
                 "> < >= <= == or != with a number, true, false or the name of an enumerator")
      ->type_name("CONDITION");
  app.add_option("--stop-when", options->stop_when,
                 "end when this event is raised or this command is executed, or when this "
                 "condition is true")
      ->type_name("CONDITION");
  app.add_option("--before", options->before,
                 "with --start-when: also write the data of this time before the start")
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformDuration, ""));
  app.add_option("--after", options->after,
                 "with --stop-when: also write the data of this time after the condition")
      ->type_name("TIME")
      ->transform(CLI::Validator(&program::TransformDuration, ""));
  app.add_option("--before-memory", options->before_bytes,
                 "maximum memory for --before: 1GB (default 256 MiB)")
      ->type_name("SIZE")
      ->transform(CLI::AsSizeValue(true));
  AddCompression(app, options->compression);
  app.add_flag("--no-log", options->has_no_log, "do not record the log of the processes");
  app.add_flag("--no-reconnect", options->ends_with_link,
               "if the GCM is lost, end instead of waiting for the GCM");
  return [options](Context& context) { return Record(context, *options); };
}

}  // namespace

std::vector<Verb> RecordVerbs() {
  return {{"record",
           "record rows, events, commands, the log and the catalogue into an MCAP file",
           &PrepareRecord,
           {"gcm record 'robot/**' -o run.mcap --for 10s",
            "gcm record '**' -o run.mcap --split-size 1GB --keep 10",
            "gcm record 'robot/**' -o run.mcap --start-when 'robot/arm/state.Joints.position[2] > "
            "1.2 rad' --before 5s --for 10s"}}};
}

}  // namespace console
