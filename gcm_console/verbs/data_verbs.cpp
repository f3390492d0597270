#include <gcm_console/catalogue/glob.h>
#include <gcm_console/catalogue/telemetry_column.h>
#include <gcm_console/outcomes.h>
#include <gcm_console/place.h>
#include <gcm_console/report.h>
#include <gcm_console/row_printer.h>
#include <gcm_console/verb.h>
#include <program/command_line.h>
#include <tendon/base/clock.h>
#include <tendon/base/os/termination.h>
#include <tendon/base/path.h>
#include <tendon/payload/json/strict_json.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iterator>
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

/// One value, and nothing but it.
Result<ExitCode> GetOne(Context& context, const std::string& text) {
  const auto path = tendon::ParsePath(text);
  if (!path) return path.error();
  const auto client = context.Client();
  if (!client) return client.error();
  const tendon::Catalog catalog = (*client)->catalog();
  if (const auto* provided = catalog.FindProvided(path->interface_name())) {
    for (const auto& command : provided->commands) {
      if (command.name != path->member || command.signature.kind == tendon::CommandKind::kRead) {
        continue;
      }
      return Error{ErrorCode::kInvalid, "'" + text + "' is a " +
                                            std::string(ToString(command.signature.kind)) +
                                            " command, which get does not call; use gcm call"};
    }
  }
  const auto value = context.Ask<std::string>(
      [&](tendon::GcmClient& asked, auto handler) { asked.Call(text, "", handler); });
  if (!value) return value.error();
  if (context.settings().json) {
    context.PrintJson({{"path", text}, {"value", tendon::JsonOrText(*value)}});
  } else {
    context.out() << *value << '\n';
  }
  return program::kOk;
}

/// The read commands that a glob names, and the columns, also with a part of each.
Result<std::vector<std::string>> ReadableThatFit(const tendon::Catalog& catalog,
                                                 const std::string& glob) {
  std::vector<std::string> paths;
  const auto things = ThingsThatFit(catalog, glob);
  for (const Thing& one : things ? *things : std::vector<Thing>()) {
    if (one.noun != "command") continue;
    const auto place = FindPlace(catalog, one.path);
    const bool is_read = place && place->member->signature.kind == tendon::CommandKind::kRead;
    if (is_read) paths.push_back(one.path);
  }
  const auto columns = ColumnsThatFit(catalog, {glob});
  if (columns) paths.insert(paths.end(), columns->paths.begin(), columns->paths.end());
  if (!paths.empty()) return paths;
  if (!things) return columns.error();
  return Error{ErrorCode::kNotFound,
               "nothing that '" + glob + "' names can be read; gcm find '" + glob + "' lists it"};
}

/// A line for each. What cannot be read is said, and the others are read all the same.
Result<ExitCode> GetAll(Context& context, const std::string& glob) {
  const auto client = context.Client();
  if (!client) return client.error();
  const auto paths = ReadableThatFit((*client)->catalog(), glob);
  if (!paths) return paths.error();
  std::vector<Outcome> outcomes;
  ordered_json values = ordered_json::array();
  for (const std::string& path : *paths) {
    const auto value = context.Ask<std::string>(
        [&](tendon::GcmClient& asked, auto handler) { asked.Call(path, "", handler); });
    outcomes.push_back({path, value ? Result<void>() : value.error()});
    if (!value) {
      context.streams().err << "gcm: " << Plain(path) << ": " << Plain(value.error().message)
                            << '\n';
    } else if (context.settings().json) {
      values.push_back({{"path", path}, {"value", tendon::JsonOrText(*value)}});
    } else {
      context.out() << Plain(path) << '\t' << *value << '\n';
    }
  }
  if (context.settings().json) context.PrintJson({{"values", std::move(values)}});
  return ExitCodeOf(outcomes);
}

struct WatchOptions {
  std::vector<std::string> paths;
  double rate = 0.0;        // rows a second, 0: all
  bool is_latest = false;   // those that wait are not wanted
  std::uint64_t count = 0;  // rows, 0: no end
  double seconds = 0.0;     // 0: no end
  bool ends_with_link = false;
};

/// Knows that the GCM was lost after it had been there.
class LostGcm final : public tendon::GcmListener {
 public:
  void OnSnapshot(const tendon::Catalog& /*catalog*/) override {
    const std::scoped_lock lock(mutex_);
    was_there_ = true;
  }
  void OnChanges(const std::vector<tendon::CatalogChange>& /*changes*/) override {}
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

/// What is watched: the rows of each table are its own.
class Watching {
 public:
  Watching(tendon::TelemetryClient& telemetry, const std::vector<TableChoice>& tables,
           const tendon::RowChoice& rows)
      : telemetry_(telemetry) {
    for (TableChoice table : tables) {
      table.subscription.rows = rows;
      const auto printer = std::make_shared<RowPrinter>(std::move(table.wanted));
      tables_.push_back({printer, telemetry.Subscribe(table.subscription, printer)});
    }
  }
  Watching(const Watching&) = delete;
  Watching& operator=(const Watching&) = delete;
  ~Watching() {
    for (const Table& table : tables_) telemetry_.Unsubscribe(table.id);
  }

  /// All rows since the last time, or the newest of each table: in order within a table, and as
  /// far as they have come among tables.
  std::vector<PrintedRow> Take(bool is_latest) {
    std::vector<PrintedRow> all;
    for (const Table& table : tables_) {
      auto rows = table.printer->Take();
      if (is_latest && !rows.empty()) rows.erase(rows.begin(), rows.end() - 1);
      std::ranges::move(rows, std::back_inserter(all));
    }
    const auto time_here = [](const PrintedRow& row) { return row.time_ns - row.clock_offset_ns; };
    if (tables_.size() > 1) std::ranges::stable_sort(all, {}, time_here);
    return all;
  }
  [[nodiscard]] std::optional<Error> mistake() const {
    bool is_any_left = false;
    for (const Table& table : tables_) {
      if (auto mistake = table.printer->mistake()) return mistake;
      is_any_left |= !table.printer->is_empty();
    }
    if (is_any_left) return std::nullopt;
    return Error{tendon::ErrorCode::kNotFound, "no column that fits has that part"};
  }
  /// Of the first table whose rows have ceased to come.
  [[nodiscard]] std::optional<Error> interruption() const {
    for (const Table& table : tables_) {
      if (auto reason = table.printer->interruption()) return reason;
    }
    return std::nullopt;
  }
  void Complain(std::ostream& err) {
    for (const Table& table : tables_) {
      for (const std::string& complaint : table.printer->TakeComplaints()) {
        err << "gcm: " << Plain(complaint) << '\n';
      }
    }
  }
  [[nodiscard]] tendon::RowCounts counts() const {
    tendon::RowCounts sum;
    for (const Table& table : tables_) {
      const tendon::RowCounts counts = telemetry_.CountsOf(table.id);
      sum.received += counts.received;
      sum.lost_table += counts.lost_table;
      sum.lost_network += counts.lost_network;
      sum.lost_viewer += counts.lost_viewer;
    }
    return sum;
  }

 private:
  struct Table {
    std::shared_ptr<RowPrinter> printer;
    tendon::TelemetryClient::Id id;
  };

  tendon::TelemetryClient& telemetry_;
  std::vector<Table> tables_;
};

/// Prints rows, on a terminal under their titles. A row of one table has "-" for those of others.
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

  /// False once as many rows as wanted are printed, or when the output is gone.
  bool Write(const PrintedRow& row) {
    ++printed_;
    Print(row);
    return (options_.count == 0 || printed_ < options_.count) && context_.out().good();
  }
  [[nodiscard]] std::uint64_t printed() const { return printed_; }

 private:
  void Print(const PrintedRow& row) {
    if (context_.settings().json) {
      ordered_json values;
      for (const auto& [path, value] : row.values) {
        values[path] = tendon::JsonOrText(value);
      }
      return context_.PrintJsonLine({{"time_ns", row.time_ns},
                                     {"clock_offset_ns", row.clock_offset_ns},
                                     {"tick", row.tick},
                                     {"values", values}});
    }
    context_.out() << row.time_ns << '\t' << row.tick;
    auto next = row.values.begin();  // in the order of the paths
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
};

void Summarize(const RowWriter& writer, const tendon::RowCounts& counts, std::ostream& err) {
  const std::uint64_t lost = counts.lost_table + counts.lost_network + counts.lost_viewer;
  err << "gcm: " << writer.printed() << " rows, " << lost << " lost";
  if (lost > 0) {
    err << " (" << counts.lost_table << " in the table, " << counts.lost_network
        << " on the network, " << counts.lost_viewer << " here)";
  }
  err << '\n';
}

Result<ExitCode> Watch(Context& context, const WatchOptions& options) {
  tendon::os::HoldTerminationSignals();
  const auto lost_gcm = options.ends_with_link ? std::make_shared<LostGcm>() : nullptr;
  const auto client = context.Client(lost_gcm);
  if (!client) return client.error();
  const auto columns = ColumnsThatFit((*client)->catalog(), options.paths);
  if (!columns) return columns.error();

  Watching watching((*client)->telemetry(), columns->tables, ChoiceOf(options));
  const auto begin = std::chrono::steady_clock::now();
  RowWriter writer(context, options, columns->paths);
  bool wants_more = true;
  bool interrupted = false;
  std::optional<Error> broken;
  while (wants_more && !interrupted && !broken) {
    interrupted = tendon::os::TerminationAsked(20ms);
    if (lost_gcm) broken = lost_gcm->reason();
    if (lost_gcm && !broken) broken = watching.interruption();
    for (const PrintedRow& row : watching.Take(options.is_latest)) {
      wants_more = writer.Write(row);
      if (!wants_more) break;
    }
    context.out().flush();
    const auto mistake = watching.mistake();  // what has led to it is complained of first
    if (!broken) watching.Complain(context.err());
    if (mistake) return *mistake;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    if (options.seconds > 0.0 && passed.count() >= options.seconds) wants_more = false;
  }
  if (context.out().good()) Summarize(writer, watching.counts(), context.err());
  if (broken && wants_more && !interrupted) return Error{ErrorCode::kUnreachable, broken->message};
  return interrupted ? program::kInterrupted : program::kOk;
}

}  // namespace

std::vector<Verb> DataVerbs() {
  return {
      {"get", "read a value once",
       [](CLI::App& app) -> Verb::Run {
         auto path = std::make_shared<std::string>();
         Names(app.add_option("path", *path,
                              "a read command or column, such as "
                              "robot/arm/state.Joints.position[0]; with *: all that it names"),
               WordKind::kReadable)
             ->required();
         return [path](Context& context) {
           return IsGlob(*path) ? GetAll(context, *path) : GetOne(context, *path);
         };
       }},
      {"watch",
       "print every row of columns of state tables: ns, tick, values",
       [](CLI::App& app) -> Verb::Run {
         auto options = std::make_shared<WatchOptions>();
         Names(app.add_option("paths", options->paths,
                              "columns, also with * and **, or a part of each (.position[0]); "
                              "each table has rows of its own, with - for the columns of others"),
               WordKind::kColumn)
             ->required();
         app.add_option("--hz", options->rate, "at most so many rows a second (default: all)")
             ->check(&program::CheckPositive);
         app.add_flag("--latest", options->is_latest,
                      "only what is the newest when there is time to print it");
         app.add_option("--count", options->count, "end after so many rows")
             ->check(&program::CheckCount);
         app.add_option("--for", options->seconds, "end after so long: 10s, 500ms, 2min")
             ->type_name("TIME")
             ->transform(CLI::Validator(&program::TransformDuration, ""));
         app.add_flag("--no-reconnect", options->ends_with_link,
                      "end when the GCM or a process is lost, rather than wait for it");
         return [options](Context& context) { return Watch(context, *options); };
       },
       {"gcm watch robot/arm/state.Joints --hz 5", "gcm watch 'robot/*/state.*' --for 10s",
        "gcm --json watch robot/arm/state.Joints.position[0] --count 100"}},
  };
}

}  // namespace console
