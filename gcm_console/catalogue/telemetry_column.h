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

}  // namespace console
