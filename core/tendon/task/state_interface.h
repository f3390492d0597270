#pragma once

#include <tendon/interface/provided_interface.h>
#include <tendon/state/state_table.h>

namespace tendon {

/// Adds one read command per column to `interface`, through which others read the table. The
/// commands return encoded values, which a caller with the column's type converts. `table` must
/// outlive `interface`.
void AddColumnReads(const StateTable& table, ProvidedInterface& interface);

}  // namespace tendon
