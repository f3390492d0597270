#pragma once

#include <gcm_console/row_printer.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalog.h>
#include <tendon/process/telemetry_client.h>

#include <string>
#include <vector>

namespace console {

/// Whether a provided interface of this name is a state table.
[[nodiscard]] bool IsTable(const std::string& interface);

/// The one subscription that gives the columns of all paths, which must lie in one table. Errors
/// name what is missing, and for a table which columns it has.
tendon::Result<tendon::TableSubscription> SubscriptionFor(const tendon::Catalog& catalog,
                                                          const std::vector<std::string>& paths,
                                                          std::vector<RowPrinter::Wanted>& wanted);

/// The rows of a table, by its path or that of a column: of this column, or the first.
tendon::Result<tendon::TableSubscription> WholeTable(const tendon::Catalog& catalog,
                                                     const std::string& path);

}  // namespace console
