#pragma once

#include <tendon/manager/component_description.h>

#include <vector>

namespace tendon::gui {

/// Returns the columns of a state table: first the columns of the component, then the cycle
/// statistics that every task records. The pointers point into `table`.
[[nodiscard]] std::vector<const ColumnDescription*> ColumnsOf(const TableDescription& table);

}  // namespace tendon::gui
