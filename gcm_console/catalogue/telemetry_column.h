#pragma once

#include <gcm_console/feeds/row_inbox.h>
#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/gcm/client.h>
#include <tendon/gcm/staleness.h>
#include <tendon/process/telemetry_client.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace console {

/// True if a provided interface of this name is a state table.
[[nodiscard]] bool IsTable(const std::string& interface);

/// The wanted columns of one table.
struct TableChoice {
  tendon::TableSubscription subscription;
  std::vector<RowInbox::Wanted> wanted;
};

/// The wanted columns, or parts of them, of any number of tables.
struct ColumnChoice {
  std::vector<std::string> paths;  ///< no duplicates; within a table in the order of its `wanted`
  std::vector<TableChoice> tables;
};

/// The columns that `patterns` name, in that order. A pattern may contain `*` and `**`, and may
/// continue into a part of a column. Errors say what is missing and, for a table, which columns it
/// has.
tendon::Result<ColumnChoice> MatchingColumns(const tendon::Catalogue& catalogue,
                                             const std::vector<std::string>& patterns);

/// Subscribes to a table by its path (first column) or by the path of a column (that column).
tendon::Result<tendon::TableSubscription> WholeTable(const tendon::Catalogue& catalogue,
                                                     const std::string& path);

/// The time on this machine's steady clock at which the newest row of the batch was written. The
/// batch must have rows.
[[nodiscard]] std::chrono::nanoseconds NewestTimeOf(const tendon::RowBatch& batch);

/// The time since a row was written; never negative, though clock offsets are estimates.
[[nodiscard]] std::chrono::nanoseconds AgeOf(std::chrono::nanoseconds written);

/// Says that the values of a component are old, and how old if known.
struct StaleValues {
  std::string component;  ///< "robot/arm"
  tendon::StaleReason why = tendon::StaleReason::kNone;
  std::optional<std::chrono::nanoseconds> age;
};

/// The age of the values of the component that `path` belongs to; empty while the component runs.
/// Measures the newest row of the table, or of the component's first table if the path names none.
/// Waits for that row up to half a second, unless the component was not started.
[[nodiscard]] std::optional<StaleValues> StaleValuesOf(tendon::GcmClient& client,
                                                       const tendon::Path& path);

/// "robot/arm is suspended: 12 s old".
[[nodiscard]] std::string ToText(const StaleValues& values);

}  // namespace console
