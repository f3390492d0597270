#include <gcm_console/catalogue/telemetry_column.h>
#include <tendon/base/path.h>
#include <tendon/gcm/lookup.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace console {
namespace {

using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

/// Of a table that is there, or why the path names none.
Result<std::vector<std::string>> ColumnsOf(const tendon::Catalog& catalog,
                                           const tendon::Path& path) {
  const std::string text = ToString(path);
  if (auto process = LookUpProcess(catalog, path.process); !process) return process.error();
  if (path.component.empty()) {
    return Error{ErrorCode::kInvalid, "'" + text +
                                          "' is a process: name a column of a component's "
                                          "state table, such as " +
                                          text + "/arm/state.Joints"};
  }
  const auto component = LookUpComponent(catalog, path.process, path.component);
  if (!component) return component.error();
  if (!IsTable(path.interface)) {
    return Error{ErrorCode::kNotFound, "'" + text +
                                           "' is no column of a state table; list them with: gcm "
                                           "ls " +
                                           path.process + "/" + path.component + "/state"};
  }
  const auto provided = LookUpProvided(catalog, path.interface_name());
  if (!provided) return provided.error();
  std::vector<std::string> columns;
  for (const auto& command : (*provided)->commands) columns.push_back(command.name);
  return columns;
}

Result<void> CheckColumn(const tendon::Path& path, const std::vector<std::string>& columns) {
  const std::string table = ToString(path.interface_name());
  if (path.member.empty()) {
    std::string all;
    for (const std::string& column : columns) all += (all.empty() ? "" : ", ") + column;
    return Error{ErrorCode::kInvalid, "'" + table +
                                          "' is a whole table: name one of its columns (" + all +
                                          "), such as " + table + "." + columns.front()};
  }
  if (std::find(columns.begin(), columns.end(), path.member) != columns.end()) return {};
  return Error{ErrorCode::kNotFound, table + " has no column '" + path.member + "'" +
                                         tendon::DidYouMean(path.member, columns)};
}

/// A glob of columns, and which part of them it goes on to: "**.Joints" and ".position[0]".
std::pair<std::string, std::string> SplitField(const std::string& pattern) {
  const std::size_t slash = pattern.rfind('/');
  const std::size_t dot = pattern.find('.', slash == pattern.npos ? 0 : slash);
  if (dot == pattern.npos) return {pattern, ""};
  const std::size_t end = pattern.find_first_of(".[", dot + 1);
  if (end == pattern.npos) return {pattern, ""};
  return {pattern.substr(0, end), pattern.substr(end)};
}

/// The paths that a glob stands for, in the catalogue's order.
Result<std::vector<std::string>> Expand(const tendon::Catalog& catalog,
                                        const std::string& pattern) {
  const auto [glob, field] = SplitField(pattern);
  if (field.find('*') != field.npos) {
    return Error{ErrorCode::kInvalid, "'" + pattern +
                                          "': a * stands for columns, not for parts of one; name "
                                          "the part, or take all of it: " +
                                          glob};
  }
  std::vector<std::string> paths;
  for (const auto& [process, entry] : catalog.processes()) {
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
    return Error{ErrorCode::kNotFound,
                 "no column fits '" + pattern + "'; list them with: gcm ls -R --type state"};
  }
  return paths;
}

tendon::InterfaceName TableOf(const TableChoice& choice) {
  return {choice.subscription.process, choice.subscription.component, choice.subscription.table};
}

/// Once, to what is wanted of its table. Who names it himself wants it in any case.
void Add(const tendon::Path& path, bool is_found, ColumnChoice& choice) {
  auto& tables = choice.tables;
  const tendon::InterfaceName name = path.interface_name();
  auto table = std::ranges::find(tables, name, &TableOf);
  if (table == tables.end()) {
    tables.push_back({{name.process, name.component, name.interface, {}}, {}});
    table = std::prev(tables.end());
  }
  const auto known = std::ranges::find(table->wanted, path, &RowPrinter::Wanted::path);
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

}  // namespace

bool IsTable(const std::string& interface) {
  return interface == "state" || interface.starts_with("state-");
}

Result<ColumnChoice> ColumnsThatFit(const tendon::Catalog& catalog,
                                    const std::vector<std::string>& patterns) {
  ColumnChoice choice;
  for (const std::string& pattern : patterns) {
    const bool is_glob = pattern.find('*') != std::string::npos;
    const auto texts = is_glob ? Expand(catalog, pattern) : std::vector<std::string>{pattern};
    if (!texts) return texts.error();
    for (const std::string& text : *texts) {
      const auto path = tendon::ParsePath(text);
      if (!path) return path.error();
      const auto known = ColumnsOf(catalog, *path);
      if (!known) return known.error();
      if (auto good = CheckColumn(*path, *known); !good) return good.error();
      Add(*path, is_glob, choice);
    }
  }
  return choice;
}

Result<tendon::TableSubscription> WholeTable(const tendon::Catalog& catalog,
                                             const std::string& text) {
  auto path = tendon::ParsePath(text);
  if (!path) return path.error();
  const auto columns = ColumnsOf(catalog, *path);
  if (!columns) return columns.error();
  if (path->member.empty()) path->member = columns->front();
  if (auto good = CheckColumn(*path, *columns); !good) return good.error();
  return tendon::TableSubscription{path->process, path->component, path->interface, {path->member}};
}

}  // namespace console
