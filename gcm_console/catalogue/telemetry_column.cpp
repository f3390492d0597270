#include <gcm_console/catalogue/telemetry_column.h>

#include <gcm_console/output/text.h>
#include <tendon/base/path.h>
#include <tendon/gcm/lookup.h>

#include <algorithm>
#include <condition_variable>
#include <iterator>
#include <memory>
#include <mutex>
#include <utility>

namespace console {
namespace {

using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

/// Returns the names of the columns of a table, or an error if the path names no table.
Result<std::vector<std::string>> ColumnsOf(const tendon::Catalogue& catalogue,
                                           const tendon::Path& path) {
  const std::string text = ToString(path);
  if (auto process = LookUpProcess(catalogue, path.process); !process) return process.error();
  if (path.component.empty()) {
    return Error{ErrorCode::kInvalid,
                 "'" + text +
                     "' is a process: give a column of a component's state table, such as " + text +
                     "/arm/state.Joints"};
  }
  const auto component = LookUpComponent(catalogue, path.process, path.component);
  if (!component) return component.error();
  if (!IsTable(path.interface)) {
    std::vector<std::string> tables;
    for (const auto& table : (*component)->tables) tables.push_back(table.name);
    return Error{ErrorCode::kNotFound,
                 "'" + text + "' is not a column of a state table; to list the columns: gcm ls " +
                     path.process + "/" + path.component + "/state" +
                     tendon::DidYouMean(path.interface, tables)};
  }
  const auto provided = LookUpProvided(catalogue, path.interface_name());
  if (!provided) return provided.error();
  std::vector<std::string> columns;
  for (const auto& command : (*provided)->commands) columns.push_back(command.name);
  return columns;
}

Result<void> CheckColumn(const tendon::Path& path, const std::vector<std::string>& columns) {
  const std::string table = ToString(path.interface_name());
  if (path.member.empty()) {
    return Error{ErrorCode::kInvalid,
                 "'" + table + "' is a whole table: give one of its columns (" +
                     Joined(columns, ", ") + "), such as " + table + "." + columns.front()};
  }
  if (std::find(columns.begin(), columns.end(), path.member) != columns.end()) return {};
  return Error{ErrorCode::kNotFound, table + " has no column '" + path.member + "'" +
                                         tendon::DidYouMean(path.member, columns)};
}

/// Splits a glob into a pattern for columns and the path of a part of a column: "**.Joints" and
/// ".position[0]".
std::pair<std::string, std::string> SplitField(const std::string& pattern) {
  const std::size_t slash = pattern.rfind('/');
  const std::size_t dot = pattern.find('.', slash == pattern.npos ? 0 : slash);
  if (dot == pattern.npos) return {pattern, ""};
  const std::size_t end = pattern.find_first_of(".[", dot + 1);
  if (end == pattern.npos) return {pattern, ""};
  return {pattern.substr(0, end), pattern.substr(end)};
}

/// Returns the paths that match a glob, in the order of the catalogue.
Result<std::vector<std::string>> Expand(const tendon::Catalogue& catalogue,
                                        const std::string& pattern) {
  const auto [glob, field] = SplitField(pattern);
  if (field.find('*') != field.npos) {
    return Error{ErrorCode::kInvalid,
                 "'" + pattern +
                     "': * can stand for columns, but not for parts of a column; write the part "
                     "without *, or use the whole column: " +
                     glob};
  }
  std::vector<std::string> paths;
  for (const auto& [process, entry] : catalogue.processes()) {
    for (const auto& [component, description] : entry.components) {
      for (const auto& provided : description.provided) {
        if (!IsTable(provided.name)) continue;
        const std::string table = process + "/" + component + "/" + provided.name + ".";
        for (const auto& column : provided.commands) {
          const std::string path = table + column.name;
          if (tendon::MatchesGlob(glob, path)) paths.push_back(path + field);
        }
      }
    }
  }
  if (paths.empty()) {
    return Error{ErrorCode::kNotFound, "no column matches '" + pattern +
                                           "'; to list the columns: gcm ls -R --type state"};
  }
  return paths;
}

tendon::InterfaceName TableOf(const TableChoice& choice) {
  return {choice.subscription.process, choice.subscription.component, choice.subscription.table};
}

/// Adds the path to its table, unless it was added before. If the user has also typed this path
/// without a glob, the path always stays in the table.
void Add(const tendon::Path& path, bool is_found, ColumnChoice& choice) {
  auto& tables = choice.tables;
  const tendon::InterfaceName name = path.interface_name();
  auto table = std::ranges::find(tables, name, &TableOf);
  if (table == tables.end()) {
    tables.push_back({{name.process, name.component, name.interface, {}}, {}});
    table = std::prev(tables.end());
  }
  const auto known = std::ranges::find(table->wanted, path, &RowInbox::WantedPath::path);
  if (known != table->wanted.end()) {
    known->is_found &= is_found;
    return;
  }
  choice.paths.push_back(ToString(path));
  auto& columns = table->subscription.columns;
  const auto place = std::ranges::find(columns, path.member);
  table->wanted.push_back({path, static_cast<std::size_t>(place - columns.begin()), is_found});
  if (place == columns.end()) columns.push_back(path.member);
}

/// Waits for the newest row of a table, and returns the time at which it was written.
class NewestRow final : public tendon::RowSink {
 public:
  void OnSubscribed(const std::vector<tendon::Schema>& /*columns*/) override {}
  void OnRows(const tendon::RowBatch& batch) override {
    if (batch.count == 0) return;
    const std::scoped_lock lock(mutex_);
    written_ = NewestTimeOf(batch);
    came_.notify_all();
  }
  void OnStale(const tendon::Error& /*reason*/) override {}

  std::optional<std::chrono::nanoseconds> WaitForAge(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    if (!came_.wait_for(lock, timeout, [this] { return written_.has_value(); })) return {};
    return AgeOf(*written_);
  }

 private:
  std::mutex mutex_;
  std::condition_variable came_;
  std::optional<std::chrono::nanoseconds> written_;
};

}  // namespace

std::chrono::nanoseconds NewestTimeOf(const tendon::RowBatch& batch) {
  return std::chrono::nanoseconds(batch.times[batch.count - 1]) - batch.clock_offset;
}

std::chrono::nanoseconds AgeOf(std::chrono::nanoseconds written) {
  const std::chrono::nanoseconds now = std::chrono::steady_clock::now().time_since_epoch();
  return std::max(std::chrono::nanoseconds(0), now - written);
}

bool IsTable(const std::string& interface) {
  return interface == "state" || interface.starts_with("state-");
}

Result<ColumnChoice> MatchingColumns(const tendon::Catalogue& catalogue,
                                     const std::vector<std::string>& patterns) {
  ColumnChoice choice;
  for (const std::string& pattern : patterns) {
    const bool is_glob = pattern.find('*') != std::string::npos;
    const auto texts = is_glob ? Expand(catalogue, pattern) : std::vector<std::string>{pattern};
    if (!texts) return texts.error();
    for (const std::string& text : *texts) {
      const auto path = tendon::ParsePath(text);
      if (!path) return path.error();
      const auto known = ColumnsOf(catalogue, *path);
      if (!known) return known.error();
      if (auto good = CheckColumn(*path, *known); !good) return good.error();
      Add(*path, is_glob, choice);
    }
  }
  return choice;
}

Result<tendon::TableSubscription> WholeTable(const tendon::Catalogue& catalogue,
                                             const std::string& text) {
  auto path = tendon::ParsePath(text);
  if (!path) return path.error();
  const auto columns = ColumnsOf(catalogue, *path);
  if (!columns) return columns.error();
  if (path->member.empty()) path->member = columns->front();
  if (auto good = CheckColumn(*path, *columns); !good) return good.error();
  return tendon::TableSubscription{path->process, path->component, path->interface, {path->member}};
}

std::optional<StaleValues> StaleValuesOf(tendon::GcmClient& client, const tendon::Path& path) {
  constexpr std::chrono::milliseconds kMaxWait(500);
  const tendon::Catalogue catalogue = client.catalogue();
  StaleValues old{path.process + "/" + path.component,
                  StaleReasonOf(catalogue, path.process, path.component),
                  {}};
  if (old.why == tendon::StaleReason::kNone) return std::nullopt;
  const auto* component = catalogue.FindComponent(path.process, path.component);
  const bool has_rows = component != nullptr && !component->tables.empty() &&
                        old.why != tendon::StaleReason::kNotStarted;
  if (!has_rows) return old;
  const auto& tables = component->tables;
  const auto named = std::find_if(tables.begin(), tables.end(),
                                  [&](const auto& one) { return one.name == path.interface; });
  const auto& table = named == tables.end() ? *tables.begin() : *named;
  if (table.columns.empty()) return old;
  const auto row = std::make_shared<NewestRow>();
  tendon::TableSubscription wanted{
      path.process, path.component, table.name, {table.columns.front().name}};
  wanted.rows.delivery = tendon::RowDelivery::kNewest;
  const auto id = client.telemetry().Subscribe(wanted, row);
  old.age = row->WaitForAge(kMaxWait);
  client.telemetry().Unsubscribe(id);
  return IsStale(old.why, old.age, 0) ? std::optional(old) : std::nullopt;
}

std::string ToText(const StaleValues& values) {
  std::string text = values.component + " is " + std::string(ToString(values.why));
  if (values.why == tendon::StaleReason::kUnresponsive)
    text = values.component + " does not answer";
  return values.age ? text + ": " + tendon::AgeText(*values.age) + " old" : text;
}

}  // namespace console
