#pragma once

#include <gcm_console/output/table.h>
#include <tendon/payload/schema.h>

#include <string>

namespace console {

/// Returns one row for each field of a payload, with type, unit, range and help. If the payload is
/// not a structure, returns one row.
Table FieldsOf(const tendon::Schema& schema);

/// Returns a JSON value of the type, as a template for the user. Each field is zero or, if its
/// range does not contain zero, the nearest value in the range.
std::string JsonSkeleton(const tendon::Schema& schema);

}  // namespace console
