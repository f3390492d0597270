#pragma once

#include <gcm_console/row_printer.h>
#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/gcm/client.h>
#include <tendon/gcm/standstill.h>
#include <tendon/process/telemetry_client.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace console {

/// Whether a provided interface of this name is a state table.
[[nodiscard]] bool IsTable(const std::string& interface);

/// What is wanted of one table.
struct TableChoice {
  tendon::TableSubscription subscription;
  std::vector<RowPrinter::Wanted> wanted;
};

/// Columns, or parts of them, of any tables.
struct ColumnChoice {
  std::vector<std::string> paths;  ///< each once; those of a table in the order of its `wanted`
  std::vector<TableChoice> tables;
};

/// Those that `patterns` name, in that order, with `*` and `**` for columns, of which a part may
/// follow. Errors name what is missing, and for a table which columns it has.
tendon::Result<ColumnChoice> ColumnsThatFit(const tendon::Catalog& catalog,
                                            const std::vector<std::string>& patterns);

/// The rows of a table, by its path or that of a column: of this column, or the first.
tendon::Result<tendon::TableSubscription> WholeTable(const tendon::Catalog& catalog,
                                                     const std::string& path);

/// That the values of a component are old, and how old, where that is known.
struct OldValues {
  std::string component;  ///< "robot/arm"
  tendon::Standstill why = tendon::Standstill::kNone;
  std::optional<std::chrono::nanoseconds> age;
};

/// Of the component that `path` belongs to; nothing while it runs. The age is that of the newest
/// row of its table, or of its first table where the path names none: waits for it for half a
/// second, unless the component was not started.
[[nodiscard]] std::optional<OldValues> OldValuesOf(tendon::GcmClient& client,
                                                   const tendon::Path& path);

/// "robot/arm is suspended: 12 s old".
[[nodiscard]] std::string ToText(const OldValues& values);

}  // namespace console
