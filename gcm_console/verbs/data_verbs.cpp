#include <gcm_console/catalogue/glob.h>
#include <gcm_console/catalogue/path_target.h>
#include <gcm_console/catalogue/telemetry_column.h>
#include <gcm_console/feeds/first_mistake.h>
#include <gcm_console/feeds/row_inbox.h>
#include <gcm_console/output/table.h>
#include <gcm_console/verbs/common_options.h>
#include <gcm_console/verbs/outcomes.h>
#include <gcm_console/verbs/verb.h>
#include <program/command_line.h>
#include <tendon/base/clock.h>
#include <tendon/base/os/termination.h>
#include <tendon/base/path.h>
#include <tendon/base/text.h>
#include <tendon/payload/json/strict_json.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <utility>

namespace console {
namespace {

using nlohmann::ordered_json;
using namespace std::chrono_literals;

ordered_json StaleValuesJson(const StaleValues& old) {
  ordered_json json;
  json["why"] = ToString(old.why);
  if (old.age) json["age_s"] = std::chrono::duration<double>(*old.age).count();
  return json;
}

/// Prints a message for each component that does not run.
class StaleComponents {
 public:
  explicit StaleComponents(Context& context, tendon::GcmClient& client)
      : context_(context), client_(client) {}

  /// Returns the age of the values if the component of the path does not run. The first call for a
  /// component also prints a message.
  const std::optional<StaleValues>& Of(const std::string& text) {
    const auto path = tendon::ParsePath(text);
    const std::string component = path ? path->process + "/" + path->component : text;
    const auto [known, is_new] = known_.try_emplace(component);
    if (is_new && path) known->second = StaleValuesOf(client_, *path);
    if (is_new && known->second) {
      context_.err() << "gcm: " << Plain(ToText(*known->second)) << '\n';
    }
    return known->second;
  }

 private:
  Context& context_;
  tendon::GcmClient& client_;
  std::map<std::string, std::optional<StaleValues>> known_;
};

/// Prints one value to the output, and nothing else. Its age is printed as a message.
Result<ExitCode> GetOne(Context& context, const std::string& text) {
  const auto path = tendon::ParsePath(text);
  if (!path) return path.error();
  const auto client = context.Client();
  if (!client) return client.error();
  const tendon::Catalogue catalogue = (*client)->catalogue();
  if (const auto* provided = catalogue.FindProvided(path->interface_name())) {
    for (const auto& command : provided->commands) {
      if (command.name != path->member || command.signature.kind == tendon::CommandKind::kRead) {
        continue;
      }
      return Error{ErrorCode::kInvalid,
                   "'" + text + "' is a " + std::string(ToString(command.signature.kind)) +
                       " command, and get cannot call such a command; use gcm call"};
    }
  }
  const auto value = context.Ask<std::string>(
      [&](tendon::GcmClient& asked, auto handler) { asked.Call(text, "", handler); });
  if (!value) return value.error();
  const auto old = StaleValuesOf(**client, *path);
  if (old) context.err() << "gcm: " << Plain(ToText(*old)) << '\n';
  if (context.settings().json) {
    ordered_json document = {{"path", text}, {"value", tendon::JsonOrText(*value)}};
    if (old) document["old"] = StaleValuesJson(*old);
    context.PrintJson(document);
  } else {
    context.out() << *value << '\n';
  }
  return program::kOk;
}

/// Returns the read commands and the columns (or parts of columns) that a glob matches.
Result<std::vector<std::string>> MatchingReadables(const tendon::Catalogue& catalogue,
                                                   const std::string& glob) {
  std::vector<std::string> paths;
  const auto items = MatchingItems(catalogue, glob);
  for (const SystemItem& one : items ? *items : std::vector<SystemItem>()) {
    if (one.kind != "command") continue;
    const auto target = FindTarget(catalogue, one.path);
    const bool is_read = target && target->member->signature.kind == tendon::CommandKind::kRead;
    if (is_read) paths.push_back(one.path);
  }
  const auto columns = MatchingColumns(catalogue, {glob});
  if (columns) paths.insert(paths.end(), columns->paths.begin(), columns->paths.end());
  if (!paths.empty()) return paths;
  if (!items) return columns.error();
  return Error{ErrorCode::kNotFound,
               "'" + glob + "' matches no value that can be read; to list the matches: gcm find '" +
                   glob + "'"};
}

/// Prints one line per value. If a value cannot be read, reports this and continues with the other
/// values.
Result<ExitCode> GetAll(Context& context, const std::string& glob) {
  const auto client = context.Client();
  if (!client) return client.error();
  const auto paths = MatchingReadables((*client)->catalogue(), glob);
  if (!paths) return paths.error();
  std::vector<Outcome> outcomes;
  StaleComponents old_components(context, **client);
  ordered_json values = ordered_json::array();
  for (const std::string& path : *paths) {
    const auto value = context.Ask<std::string>(
        [&](tendon::GcmClient& asked, auto handler) { asked.Call(path, "", handler); });
    outcomes.push_back({path, value ? Result<void>() : value.error()});
    if (!value) {
      context.streams().err << "gcm: " << Plain(path) << ": " << Plain(value.error().message)
                            << '\n';
    } else if (context.settings().json) {
      ordered_json one = {{"path", path}, {"value", tendon::JsonOrText(*value)}};
      if (const auto& old = old_components.Of(path)) one["old"] = StaleValuesJson(*old);
      values.push_back(std::move(one));
    } else {
      (void)old_components.Of(path);
      context.out() << Plain(path) << '\t' << *value << '\n';
    }
  }
  if (context.settings().json) context.PrintJson({{"values", std::move(values)}});
  return ExitCodeOf(outcomes);
}

struct WatchOptions {
  std::vector<std::string> paths;
  double rate = 0.0;        // rows per second; 0: all
  bool is_latest = false;   // print only the newest row
  std::uint64_t count = 0;  // number of rows; 0: no limit
  double seconds = 0.0;     // 0: no limit
  bool ends_with_link = false;
};

/// Records that a GCM was found and then lost.
class GcmLossListener final : public tendon::GcmListener {
 public:
  void OnSnapshot(const tendon::Catalogue& /*catalogue*/) override {
    const std::scoped_lock lock(mutex_);
    was_there_ = true;
  }
  void OnChanges(const std::vector<tendon::CatalogueChange>& /*changes*/) override {}
  void OnGcmLost(const Error& reason) override {
    const std::scoped_lock lock(mutex_);
    if (was_there_) reason_ = reason;
  }
  [[nodiscard]] std::optional<Error> reason() const {
    const std::scoped_lock lock(mutex_);
    return reason_;
  }

 private:
  mutable std::mutex mutex_;
  bool was_there_ = false;
  std::optional<Error> reason_;
};

tendon::RowChoice ChoiceOf(const WatchOptions& options) {
  tendon::RowChoice rows;
  if (options.rate > 0.0) {
    constexpr std::chrono::duration<double> kLongest = tendon::kLongestWait;
    const std::chrono::duration<double> period(1.0 / options.rate);
    rows.period = std::chrono::duration_cast<std::chrono::nanoseconds>(std::min(period, kLongest));
  }
  if (options.is_latest) rows.delivery = tendon::RowDelivery::kNewest;
  return rows;
}

/// The tables that are watched. Each table has its own queue of rows.
class WatchedTables {
 public:
  WatchedTables(tendon::TelemetryClient& telemetry, const std::vector<TableChoice>& tables,
                const tendon::RowChoice& rows)
      : telemetry_(telemetry) {
    for (TableChoice table : tables) {
      table.subscription.rows = rows;
      const auto inbox = std::make_shared<RowInbox>(std::move(table.wanted), rows.delivery);
      const auto& [process, component, name, columns, choice] = table.subscription;
      tables_.push_back({ToString(tendon::InterfaceName(process, component, name)), inbox,
                         telemetry.Subscribe(table.subscription, inbox)});
    }
  }
  WatchedTables(const WatchedTables&) = delete;
  WatchedTables& operator=(const WatchedTables&) = delete;
  ~WatchedTables() { End(); }

  /// Ends the subscriptions; no more rows arrive after this call.
  void End() {
    if (std::exchange(has_ended_, true)) return;
    for (const Table& table : tables_) telemetry_.Unsubscribe(table.id);
  }

  struct Row {
    const std::string* table = nullptr;
    PrintedRow content;
  };
  /// Returns the next rows of all tables. The rows of one table are in order; rows of different
  /// tables are in the order of their arrival.
  std::vector<Row> Take() {
    std::vector<Row> all;
    for (const Table& table : tables_) {
      for (PrintedRow& row : table.inbox->Take()) all.push_back({&table.name, std::move(row)});
    }
    const auto time_here = [](const Row& row) {
      return row.content.time_ns - row.content.clock_offset_ns;
    };
    if (tables_.size() > 1) std::ranges::stable_sort(all, {}, time_here);
    return all;
  }
  [[nodiscard]] bool has_more() const {
    return std::ranges::any_of(tables_, [](const Table& one) { return one.inbox->has_more(); });
  }
  /// Returns the size of the rows of all tables that were not taken yet.
  [[nodiscard]] std::size_t waiting_bytes() const {
    std::size_t all = 0;
    for (const Table& table : tables_) all += table.inbox->waiting_bytes();
    return all;
  }
  /// Returns the number of rows that were lost in each table after the last printed row.
  std::vector<std::pair<const std::string*, tendon::LostRows>> Rest() {
    std::vector<std::pair<const std::string*, tendon::LostRows>> all;
    for (const Table& table : tables_) all.emplace_back(&table.name, table.inbox->Rest());
    return all;
  }
  [[nodiscard]] std::optional<Error> mistake() const {
    return FirstMistake(
        tables_, &Table::inbox,
        "no matching column has this part; to list the parts of a column: gcm show COLUMN");
  }
  /// Returns the reason of an interruption, from the first table that has one.
  [[nodiscard]] std::optional<Error> interruption() const {
    for (const Table& table : tables_) {
      if (auto reason = table.inbox->interruption()) return reason;
    }
    return std::nullopt;
  }
  void Complain(std::ostream& err) {
    for (const Table& table : tables_) PrintSentences(table.inbox->TakeNotices(), err);
  }

 private:
  struct Table {
    std::string name;
    std::shared_ptr<RowInbox> inbox;
    tendon::TelemetryClient::Id id;
  };

  tendon::TelemetryClient& telemetry_;
  std::vector<Table> tables_;
  bool has_ended_ = false;
};

std::string LostText(const tendon::LostRows& lost) {
  return std::to_string(lost.table) + " in the table, " + std::to_string(lost.network) +
         " on the network, " + std::to_string(lost.viewer) + " in gcm";
}

/// Prints rows, on a terminal with titles. A row shows "-" in the columns of other tables. Lost
/// rows are reported: with --json as separate records, otherwise as messages, at most one per
/// second.
class RowWriter {
 public:
  RowWriter(Context& context, const WatchOptions& options, std::vector<std::string> paths)
      : context_(context), options_(options), paths_(std::move(paths)) {
    const bool has_titles = context.columns() > 0 && context.settings().titles;
    if (!has_titles || context.settings().json) return;
    context.out() << "TIME/ns        \tTICK";  // as wide as a time
    for (const std::string& path : paths_) context.out() << '\t' << Plain(path);
    context.out() << '\n';
  }

  /// Prints a row. Returns false if the requested number of rows was printed, or if the output is
  /// closed.
  bool Write(const std::string& table, const PrintedRow& row) {
    Miss(table, row.lost_before);
    ++printed_;
    Print(row);
    return !is_full() && context_.out().good();
  }
  /// Counts rows that were lost and are not printed.
  void Miss(const std::string& table, const tendon::LostRows& rows) {
    if (rows.all() > 0) ReportGap(table, rows);
    lost_ += rows;
  }
  /// True if the requested number of rows was printed.
  [[nodiscard]] bool is_full() const { return options_.count > 0 && printed_ >= options_.count; }
  /// True if only the newest row is requested.
  [[nodiscard]] bool is_latest() const { return options_.is_latest; }
  [[nodiscard]] std::uint64_t printed() const { return printed_; }
  [[nodiscard]] const tendon::LostRows& lost() const { return lost_; }

 private:
  void ReportGap(const std::string& table, const tendon::LostRows& lost) {
    if (context_.settings().json) {
      return context_.PrintJsonLine({{"gap",
                                      {{"table", table},
                                       {"lost_table", lost.table},
                                       {"lost_network", lost.network},
                                       {"lost_viewer", lost.viewer}}}});
    }
    unreported_[table] += lost;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_report_ < 1s) return;
    last_report_ = now;
    for (const auto& [name, some] : std::exchange(unreported_, {})) {
      context_.err() << "gcm: " << Plain(name) << ": "
                     << tendon::Counted(some.all(), "row is lost", "rows are lost") << " ("
                     << LostText(some) << ")\n";
    }
  }

  /// Writes the values unchanged, because they are JSON already and may have many megabytes.
  void PrintAsJson(const PrintedRow& row) {
    std::ostream& out = context_.out();
    out << R"({"schema":1,"time_ns":)" << row.time_ns << R"(,"clock_offset_ns":)"
        << row.clock_offset_ns << R"(,"tick":)" << row.tick << R"(,"values":{)";
    const char* separator = "";
    for (const auto& [path, value] : row.values) {
      out << std::exchange(separator, ",") << nlohmann::json(path) << ':' << value;
    }
    out << "}}\n";
  }

  void Print(const PrintedRow& row) {
    if (context_.settings().json) return PrintAsJson(row);
    context_.out() << row.time_ns << '\t' << row.tick;
    auto next = row.values.begin();  // the values are in the order of the paths
    for (const std::string& path : paths_) {
      const bool is_ours = next != row.values.end() && next->first == path;
      context_.out() << '\t' << (is_ours ? (next++)->second : "-");
    }
    context_.out() << '\n';
  }

  Context& context_;
  const WatchOptions& options_;
  const std::vector<std::string> paths_;
  std::uint64_t printed_ = 0;
  tendon::LostRows lost_;
  std::map<std::string, tendon::LostRows>
      unreported_;  // lost rows that were not reported yet, by table
  std::chrono::steady_clock::time_point last_report_;
};

/// Reports when a watched component stops running, and when it runs again. Each change is reported
/// once. Look() may have to wait for the age of a component's values. After such a wait it returns,
/// so that signals are handled in time; the next call continues with the next component.
class StandstillNotices {
 public:
  StandstillNotices(Context& context, tendon::GcmClient& client,
                    const std::vector<TableChoice>& tables)
      : context_(context), client_(client) {
    for (const TableChoice& table : tables) {
      const auto& wanted = table.subscription;
      const std::string name = wanted.process + "/" + wanted.component;
      if (std::ranges::find(watched_, name, &WatchedColumns::name) != watched_.end()) continue;
      watched_.push_back({.name = name,
                          .path = {.process = wanted.process,
                                   .component = wanted.component,
                                   .interface = wanted.table}});
    }
  }

  void Look() {
    constexpr std::chrono::milliseconds kOften(500);
    if (std::chrono::steady_clock::now() < next_round_) return;
    const tendon::Catalogue catalogue = client_.catalogue();
    while (next_ < watched_.size()) {
      if (LookAt(catalogue, watched_[next_++])) return;
    }
    next_ = 0;
    next_round_ = std::chrono::steady_clock::now() + kOften;
  }

 private:
  using StaleReason = tendon::StaleReason;
  struct WatchedColumns {
    std::string name;
    tendon::Path path;
    StaleReason reported = StaleReason::kNone;
  };

  /// Checks one component. Returns true if the check may have waited for a reply.
  bool LookAt(const tendon::Catalogue& catalogue, WatchedColumns& watched) {
    const StaleReason why = StaleReasonOf(catalogue, watched.path.process, watched.path.component);
    // A lost process is not reported here, because the end of its rows is reported.
    if (why == watched.reported || why == StaleReason::kLost) return false;
    if (why == StaleReason::kNone) {
      context_.err() << "gcm: " << Plain(watched.name) << " runs again\n";
      watched.reported = why;
      return false;
    }
    if (const auto old = StaleValuesOf(client_, watched.path)) {
      context_.err() << "gcm: " << Plain(ToText(*old)) << '\n';
      watched.reported = why;
    }
    return true;
  }

  Context& context_;
  tendon::GcmClient& client_;
  std::vector<WatchedColumns> watched_;
  std::size_t next_ = 0;
  std::chrono::steady_clock::time_point next_round_;
};

void Summarize(const RowWriter& writer, std::ostream& err) {
  const tendon::LostRows& lost = writer.lost();
  err << "gcm: " << tendon::Counted(writer.printed(), "row", "rows") << ", " << lost.all()
      << " lost";
  if (lost.all() > 0) err << " (" << LostText(lost) << ')';
  err << '\n';
}

/// Prints the rows. Returns false if no more rows are wanted. After a signal, a write that would
/// block fails. The remaining rows then count as lost.
bool WriteRows(RowWriter& writer, const std::vector<WatchedTables::Row>& rows) {
  std::map<std::string, tendon::LostRows> missed;
  bool wants_more = true;
  for (const auto& [table, row] : rows) {
    if (wants_more) {
      wants_more = writer.Write(*table, row);
      continue;
    }
    missed[*table] += row.lost_before;
    missed[*table].viewer += writer.is_latest() ? 0 : 1;
  }
  const bool is_left = !wants_more && !tendon::os::WasTerminationRequested();
  // If the reader has closed the output, the remaining rows do not count as lost.
  if (writer.is_full() || is_left) return wants_more;
  for (const auto& [table, lost] : missed) writer.Miss(table, lost);
  return wants_more;
}

/// Prints the rows that were not taken yet if they are few. Otherwise they count as lost.
void WriteRest(WatchedTables& tables, RowWriter& writer, Context& context) {
  constexpr std::size_t kFew = std::size_t{64} << 10U;  // bytes
  if (writer.is_full()) return;
  tables.End();
  if (context.out().good() && tables.waiting_bytes() <= kFew) {
    WriteRows(writer, tables.Take());
  }
  if (writer.is_full()) return;
  for (const auto& [table, lost] : tables.Rest()) writer.Miss(*table, lost);
  context.out().flush();
}

Result<ExitCode> Watch(Context& context, const WatchOptions& options) {
  tendon::os::HoldTerminationSignals();
  const auto gcm_loss = options.ends_with_link ? std::make_shared<GcmLossListener>() : nullptr;
  const auto client = context.Client(gcm_loss);
  if (!client) return client.error();
  const auto columns = MatchingColumns((*client)->catalogue(), options.paths);
  if (!columns) return columns.error();

  WatchedTables tables((*client)->telemetry(), columns->tables, ChoiceOf(options));
  const auto begin = std::chrono::steady_clock::now();
  RowWriter writer(context, options, columns->paths);
  StandstillNotices notices(context, **client, columns->tables);
  bool wants_more = true;
  bool interrupted = false;
  std::optional<Error> broken;
  while (wants_more && !interrupted && !broken) {
    interrupted = tendon::os::TerminationRequested(tables.has_more() ? 0ms : 20ms);
    if (gcm_loss) broken = gcm_loss->reason();
    if (gcm_loss && !broken) broken = tables.interruption();
    if (!interrupted) wants_more = WriteRows(writer, tables.Take());
    context.out().flush();
    interrupted = interrupted || tendon::os::TerminationRequested(0ms);
    if (wants_more && !interrupted) notices.Look();
    const auto mistake = tables.mistake();  // the reason of a mistake was already reported
    if (!broken) tables.Complain(context.err());
    if (mistake) return *mistake;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    if (options.seconds > 0.0 && passed.count() >= options.seconds) wants_more = false;
  }
  // The output is bad if the reader has closed it.
  if (context.out().good() || interrupted) {
    WriteRest(tables, writer, context);
    Summarize(writer, context.err());
  }
  if (broken && wants_more && !interrupted) return Error{ErrorCode::kUnreachable, broken->message};
  return interrupted ? program::kInterrupted : program::kOk;
}

}  // namespace

std::vector<Verb> DataVerbs() {
  return {
      {"get", "read a value once",
       [](CLI::App& app) -> Verb::Run {
         auto path = std::make_shared<std::string>();
         WithKind(
             app.add_option("path", *path,
                            "a read command or a column, such as "
                            "robot/arm/state.Joints.position[0]; a pattern with * matches several"),
             WordKind::kReadable)
             ->required();
         return [path](Context& context) {
           return IsGlob(*path) ? GetAll(context, *path) : GetOne(context, *path);
         };
       }},
      {"watch",
       "print every new row of state tables: time in ns, tick, values",
       [](CLI::App& app) -> Verb::Run {
         auto options = std::make_shared<WatchOptions>();
         WithKind(
             app.add_option("paths", options->paths,
                            "columns of state tables, or parts of columns (.position[0]); * and ** "
                            "match several columns; with columns of several tables, each row comes "
                            "from one table, and has \"-\" for the columns of the others"),
             WordKind::kColumn)
             ->required();
         app.add_option("--hz", options->rate,
                        "print at most this many rows per second (default: all rows)")
             ->transform(CLI::Validator(&program::TransformPositive, ""));
         app.add_flag(
             "--latest", options->is_latest,
             "print only the newest row; skip rows if they come faster than they can be printed");
         AddCount(app, options->count, "end after this many rows");
         AddDuration(app, options->seconds);
         AddNoReconnect(app, options->ends_with_link);
         return [options](Context& context) { return Watch(context, *options); };
       },
       {"gcm watch robot/arm/state.Joints --hz 5", "gcm watch 'robot/*/state.*' --for 10s",
        "gcm --json watch robot/arm/state.Joints.position[0] --count 100"}},
  };
}

}  // namespace console
