#pragma once

#include <tendon/manager/component_description.h>

#include <vector>

namespace tendon::gui {

/// The columns of a state table: first the component's own, then the cycle statistics that every
/// task records. The pointers refer to `table`.
[[nodiscard]] std::vector<const ColumnDescription*> ColumnsOf(const TableDescription& table);

}  // namespace tendon::gui
