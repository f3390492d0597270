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

/// Returns true if a provided interface with this name is a state table.
[[nodiscard]] bool IsTable(const std::string& interface);

/// The columns of one table that the user wants.
struct TableChoice {
  tendon::TableSubscription subscription;
  std::vector<RowInbox::WantedPath> wanted;
};

/// The columns, or parts of columns, that the user wants, from any number of tables.
struct ColumnChoice {
  std::vector<std::string> paths;  ///< no duplicates; for one table, in the order of `wanted`
  std::vector<TableChoice> tables;
};

/// Returns the columns that `patterns` name, in the order of the patterns. A pattern may contain
/// `*` and `**`, and may continue into a part of a column. An error says what is missing; if a
/// column is missing, it also lists the columns of the table.
tendon::Result<ColumnChoice> MatchingColumns(const tendon::Catalogue& catalogue,
                                             const std::vector<std::string>& patterns);

/// Returns the subscription for a path. If the path names a table, the subscription is for its
/// first column; otherwise it is for the column that the path names.
tendon::Result<tendon::TableSubscription> WholeTable(const tendon::Catalogue& catalogue,
                                                     const std::string& path);

/// Returns the time, on this machine's steady clock, at which the newest row of the batch was
/// written. The batch must contain rows.
[[nodiscard]] std::chrono::nanoseconds NewestTimeOf(const tendon::RowBatch& batch);

/// Returns the time since a row was written. Never negative, although clock offsets are only
/// estimates.
[[nodiscard]] std::chrono::nanoseconds AgeOf(std::chrono::nanoseconds written);

/// The information that the values of a component are old, and their age if it is known.
struct StaleValues {
  std::string component;  ///< "robot/arm"
  tendon::StaleReason why = tendon::StaleReason::kNone;
  std::optional<std::chrono::nanoseconds> age;
};

/// Returns how old the values of a component are; empty if the component runs. `path` names the
/// component or an object in it. The age is the age of the newest row in the table that the path
/// names. If the path names no table, the first table of the component is used. Waits at most half
/// a second for this row, and not at all if the component was not started.
[[nodiscard]] std::optional<StaleValues> StaleValuesOf(tendon::GcmClient& client,
                                                       const tendon::Path& path);

/// Returns "robot/arm is suspended: 12 s old".
[[nodiscard]] std::string ToText(const StaleValues& values);

}  // namespace console
