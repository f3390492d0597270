#pragma once

#include <gcm_console/output/table.h>
#include <tendon/payload/schema.h>

#include <string>

namespace console {

/// One row per field of a payload: type, unit, range and help. A payload that is not a structure is
/// one row.
Table FieldsOf(const tendon::Schema& schema);

/// A JSON value of the type as a template for the user: each field is zero, or the nearest value
/// within its range.
std::string JsonSkeleton(const tendon::Schema& schema);

}  // namespace console
