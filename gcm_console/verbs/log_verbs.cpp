#include <gcm_console/catalogue/glob.h>
#include <gcm_console/feeds/inbox_queue.h>
#include <gcm_console/output/table.h>
#include <gcm_console/verbs/outcomes.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/base/os/termination.h>
#include <tendon/base/path.h>
#include <tendon/base/text.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/text.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace console {
namespace {

using tendon::LogLevel;
using tendon::message::LogRecord;
using namespace std::chrono_literals;

struct LogOptions {
  bool follow = false;
  std::string level = "debug";  // the lowest level
  std::string from{};           // if empty, all sources
};

std::vector<std::string> LevelNames() {
  std::vector<std::string> names;
  for (const auto& one : tendon::kPayload<LogLevel>.enumerators) names.emplace_back(one.name);
  return names;
}

/// Returns the level with this name.
LogLevel LevelOf(const std::string& name) {
  for (const auto& one : tendon::kPayload<LogLevel>.enumerators) {
    if (one.name == name) return one.value;
  }
  return LogLevel::kDebug;
}

/// Stores records until the printing thread takes them. The queue is limited in records and bytes.
/// When it is full, the oldest records are dropped and counted as lost.
class LogInbox final : public tendon::GcmListener {
 public:
  using Records = InboxQueue<LogRecord, std::uint64_t>;

  struct Content {
    std::deque<Records::Entry> records;
    std::uint64_t lost = 0;  // records lost after the last of `records`
    bool is_current = false;
    bool has_more = false;  // more records can be taken
    bool is_gcm_back = false;
    std::string complaint;
  };

  void OnSnapshot(const tendon::Catalogue& /*catalogue*/) override {
    const std::scoped_lock lock(mutex_);
    content_.is_gcm_back = std::exchange(is_gcm_lost_, false) || content_.is_gcm_back;
  }
  void OnChanges(const std::vector<tendon::CatalogueChange>& /*changes*/) override {}
  void OnGcmLost(const Error& reason) override {
    const std::scoped_lock lock(mutex_);
    content_.complaint = reason.message;
    content_.is_gcm_back = false;
    is_gcm_lost_ = true;
  }
  void OnLog(const tendon::LogBatch& batch) override {
    const std::scoped_lock lock(mutex_);
    records_.AddLost(batch.lost);
    content_.is_current = batch.is_current;
    for (const LogRecord& record : batch.records) {
      const std::size_t size = sizeof record + record.text.size() + record.source.size();
      records_.Push(record, size, [](const LogRecord& /*oldest*/) { return std::uint64_t{1}; });
    }
  }

  /// Returns everything since the last call; the oldest records come first.
  Content Take() {
    const std::scoped_lock lock(mutex_);
    const bool is_current = content_.is_current;
    Content content = std::exchange(content_, {.is_current = is_current});
    content.records = records_.Take();
    content.lost = records_.TakeLost();
    content.has_more = !records_.is_empty();
    content.is_current = is_current && !content.has_more;
    return content;
  }

 private:
  std::mutex mutex_;
  Content content_;  // without the records and the losses
  Records records_;
  bool is_gcm_lost_ = false;
};

bool IsWanted(const LogRecord& record, const LogOptions& options) {
  return record.level >= LevelOf(options.level) &&
         (options.from.empty() || tendon::MatchesGlob(options.from, record.process) ||
          tendon::MatchesGlob(options.from, record.process + "/" + record.source));
}

void Print(const LogRecord& record, const Context& context) {
  if (context.settings().json) {
    return context.PrintJsonLine({{"time_ns", record.time},
                                  {"level", ToString(record.level)},
                                  {"process", record.process},
                                  {"source", record.source},
                                  {"text", record.text}});
  }
  const bool is_of_process = record.source == record.process;
  const std::string level(ToString(record.level));
  context.out() << tendon::FineWallTimeText(record.time) << '\t'
                << Coloured(level, context.layout().is_coloured) << '\t' << Plain(record.process)
                << (is_of_process ? "" : "/" + Plain(record.source)) << '\t' << Plain(record.text)
                << '\n';
}

void PrintLost(std::uint64_t lost, Context& context) {
  if (lost == 0) return;
  if (context.settings().json) context.PrintJsonLine({{"gap", {{"lost", lost}}}});
  context.err() << "gcm: " << tendon::Counted(lost, "record is lost", "records are lost")
                << ", because the records came faster than gcm could print them\n";
}

void PrintNotices(const LogInbox::Content& content, Context& context) {
  if (!content.complaint.empty()) context.err() << "gcm: " << Plain(content.complaint) << '\n';
  if (content.is_gcm_back) context.PrintGcmReturn();
}

/// Called if no stored record matches. Prints a message about it. Returns kNotFound if there is no
/// such process.
Result<void> CheckFrom(const LogOptions& options, const std::set<std::string>& processes,
                       Context& context) {
  const std::string name = options.from.substr(0, options.from.find('/'));
  if (!options.from.empty() && !IsGlob(name) && !processes.contains(name)) {
    const auto client = context.Client();
    if (!client) return client.error();
    const tendon::Catalogue catalogue = (*client)->catalogue();
    if (const auto known = LookUpProcess(catalogue, name); !known) return known.error();
  }
  const std::string from = options.from.empty() ? "" : "from '" + Plain(options.from) + "' ";
  context.err() << "gcm: the GCM keeps no record " << from << "at level " << options.level
                << " or above\n";
  return {};
}

/// The records that the GCM had stored at the time of the request.
struct KeptRecords {
  std::deque<LogRecord> records;
  std::uint64_t lost = 0;  // records lost between the stored ones
};

/// Sorts the records by time, because they arrive in the order in which the GCM has received them.
/// All losses are printed first, because they have no position among the sorted records.
Result<void> PrintKept(KeptRecords kept, const LogOptions& options, Context& context) {
  auto& records = kept.records;
  std::set<std::string> processes;
  for (const LogRecord& record : records) processes.insert(record.process);
  std::erase_if(records, [&](const LogRecord& record) { return !IsWanted(record, options); });
  std::ranges::stable_sort(records, {}, &LogRecord::time);
  PrintLost(kept.lost, context);
  for (const LogRecord& record : records) Print(record, context);
  return records.empty() && !options.follow ? CheckFrom(options, processes, context)
                                            : Result<void>();
}

/// Prints the records and the losses between them. After a signal, returns false: the remaining
/// records are not printed, and their losses are not counted.
bool PrintNew(const LogInbox::Content& content, const LogOptions& options, Context& context) {
  for (const auto& [record, lost_before] : content.records) {
    PrintLost(lost_before, context);
    if (IsWanted(record, options)) Print(record, context);
    if (tendon::os::TerminationRequested(0ms)) return false;
  }
  PrintLost(content.lost, context);
  return true;
}

Result<ExitCode> ShowLog(Context& context, const LogOptions& options) {
  if (options.follow) tendon::os::HoldTerminationSignals();
  const auto inbox = std::make_shared<LogInbox>();
  const auto client = context.Client(inbox);
  if (!client) return client.error();
  (*client)->WatchLog();
  const auto begin = std::chrono::steady_clock::now();
  KeptRecords kept;
  bool is_current = false;
  bool has_more = false;
  while (true) {
    bool is_interrupted = tendon::os::TerminationRequested(has_more ? 0ms : 20ms);
    const LogInbox::Content content = inbox->Take();
    has_more = content.has_more;
    if (!is_current) {
      for (const auto& [record, lost_before] : content.records) {
        kept.records.push_back(record);
        kept.lost += lost_before;
      }
      kept.lost += content.lost;
      if (content.is_current || is_interrupted) {
        const auto printed = PrintKept(std::exchange(kept, {}), options, context);
        if (!printed) return printed.error();
      }
    } else {
      is_interrupted = is_interrupted || !PrintNew(content, options, context);
    }
    is_current = is_current || content.is_current;
    PrintNotices(content, context);
    context.out().flush();
    if (is_interrupted) return program::kInterrupted;
    if (!context.out().good() || (content.is_current && !options.follow)) return program::kOk;
    if (options.follow || std::chrono::steady_clock::now() - begin < context.settings().timeout) {
      continue;
    }
    if (!kept.records.empty() || kept.lost > 0) (void)PrintKept(std::move(kept), options, context);
    return Error{ErrorCode::kTimeout,
                 "the GCM has not sent its whole log in time; to wait longer: --timeout"};
  }
}

struct LevelOrder {
  std::string process;
  std::string level;
  bool dry_run = false;
};

/// Checks whether the log level of the process can be set.
Result<void> CheckLevelOrder(Context& context, const LevelOrder& order) {
  if (auto allowed = CheckRole(context); !allowed) return allowed;
  const auto client = context.Client();
  if (!client) return client.error();
  const tendon::Catalogue catalogue = (*client)->catalogue();
  const auto entry = LookUpProcess(catalogue, order.process);
  return entry ? RequirePresent((*entry)->process) : Result<void>(entry.error());
}

Result<void> SetOneLevel(Context& context, const LevelOrder& order) {
  if (order.dry_run) return CheckLevelOrder(context, order);
  return context.Ask<void>([&](tendon::GcmClient& client, auto handler) {
    client.SetLogLevel(order.process, LevelOf(order.level), handler);
  });
}

/// Sets the log level of all present processes that match a glob.
Result<ExitCode> SetLevels(Context& context, const LevelOrder& order) {
  const auto client = context.Client();
  if (!client) return client.error();
  const tendon::Catalogue catalogue = (*client)->catalogue();
  std::vector<Outcome> outcomes;
  for (const auto& [name, entry] : catalogue.processes()) {
    if (!tendon::MatchesGlob(order.process, name) || !IsPresent(entry.process)) continue;
    outcomes.push_back({name, SetOneLevel(context, {name, order.level, order.dry_run})});
  }
  if (outcomes.empty()) {
    return Error{ErrorCode::kNotFound, "no available process matches '" + order.process +
                                           "'; to list all processes: gcm ls"};
  }
  PrintOutcomes(context, {"log-level", "set to log " + order.level + " and above", order.dry_run},
                outcomes);
  return ExitCodeOf(outcomes);
}

Result<ExitCode> SetLevel(Context& context, const LevelOrder& order) {
  if (IsGlob(order.process)) return SetLevels(context, order);
  if (auto set = SetOneLevel(context, order); !set) return set.error();
  if (context.settings().json) {
    context.PrintJson(
        {{"process", order.process}, {"level", order.level}, {"dry_run", order.dry_run}});
  } else {
    context.out() << order.process << (order.dry_run ? "  would log " : "  logs ") << order.level
                  << " and above\n";
  }
  return program::kOk;
}

}  // namespace

std::vector<Verb> LogVerbs() {
  return {
      {"log",
       "print what the processes log: time, level, process/source, text",
       [](CLI::App& app) -> Verb::Run {
         auto options = std::make_shared<LogOptions>();
         app.add_flag("-f,--follow", options->follow,
                      "keep running, and print new records when they arrive");
         app.add_option("--level", options->level, "the lowest level to print (default: all)")
             ->check(CLI::IsMember(LevelNames()));
         app.add_option(
             "--from", options->from,
             "process or process/source; a pattern with * or ** matches several (default: all)");
         return [options](Context& context) { return ShowLog(context, *options); };
       },
       {"gcm log --follow --level warning", "gcm log --from 'robot/**'"}},
      {"log-level", "set the lowest level that a process logs; this lasts until the process ends",
       [](CLI::App& app) -> Verb::Run {
         auto order = std::make_shared<LevelOrder>();
         WithKind(app.add_option("process", order->process, "process, or a pattern such as r*"),
                  WordKind::kProcess)
             ->required();
         app.add_option("level", order->level, "debug, info, warning or error")
             ->required()
             ->check(CLI::IsMember(LevelNames()));
         app.add_flag("--dry-run", order->dry_run, "only print what would be set");
         return [order](Context& context) { return SetLevel(context, *order); };
       }},
  };
}

}  // namespace console
