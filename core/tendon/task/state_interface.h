#pragma once

#include <tendon/interface/provided_interface.h>
#include <tendon/state/state_table.h>

namespace tendon {

/// Adds one read command a column to `interface`, by which others see the table. The commands read
/// encoded rows, so a caller with the column's type converts. `table` must outlive `interface`.
void AddColumnReads(const StateTable& table, ProvidedInterface& interface);

}  // namespace tendon
