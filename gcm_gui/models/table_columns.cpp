#include <gcm_gui/models/table_columns.h>

#include <tendon/task/cycle_statistics.h>

#include <algorithm>

namespace tendon::gui {
namespace {

bool IsOwn(const ColumnDescription* column) {
  return column->type != kPayload<CycleStatistics>.name &&
         column->type != kPayload<CycleSummary>.name;
}

}  // namespace

std::vector<const ColumnDescription*> ColumnsOf(const TableDescription& table) {
  std::vector<const ColumnDescription*> columns;
  for (const auto& column : table.columns) columns.push_back(&column);
  std::stable_partition(columns.begin(), columns.end(), IsOwn);
  return columns;
}

}  // namespace tendon::gui
