#include <gcm_console/catalogue/telemetry_column.h>
#include <tendon/base/path.h>
#include <tendon/gcm/lookup.h>

#include <algorithm>

namespace console {
namespace {

using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

/// Of a table that is there, or why the path names none.
Result<std::vector<std::string>> ColumnsOf(const tendon::Catalog& catalog,
                                           const tendon::Path& path) {
  const std::string text = ToString(path);
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

}  // namespace

bool IsTable(const std::string& interface) {
  return interface == "state" || interface.starts_with("state-");
}

Result<tendon::TableSubscription> SubscriptionFor(const tendon::Catalog& catalog,
                                                  const std::vector<std::string>& paths,
                                                  std::vector<RowPrinter::Wanted>& wanted) {
  tendon::TableSubscription subscription;
  for (const std::string& text : paths) {
    const auto path = tendon::ParsePath(text);
    if (!path) return path.error();
    const auto known = ColumnsOf(catalog, *path);
    if (!known) return known.error();
    if (auto good = CheckColumn(*path, *known); !good) return good.error();
    const tendon::InterfaceName name = path->interface_name();
    if (wanted.empty()) {
      subscription = {name.process, name.component, name.interface, {}};
    } else if (tendon::InterfaceName(subscription.process, subscription.component,
                                     subscription.table) != name) {
      return Error{ErrorCode::kInvalid, "'" + text + "' is in another table than '" + paths[0] +
                                            "'; watch one table at a time"};
    }
    auto& columns = subscription.columns;
    const auto place = std::find(columns.begin(), columns.end(), path->member);
    wanted.push_back({*path, static_cast<std::size_t>(place - columns.begin())});
    if (place == columns.end()) columns.push_back(path->member);
  }
  return subscription;
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
