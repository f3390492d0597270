#pragma once

#include <tendon/manager/description.h>

#include <vector>

namespace tendon::gui {

/// The columns of a state table in the order of their interest: the component's own, then what
/// every task keeps about its cycles. They point into `table`.
[[nodiscard]] std::vector<const ColumnDescription*> ColumnsOf(const TableDescription& table);

}  // namespace tendon::gui
