#pragma once

#include <gcm_console/report.h>
#include <tendon/payload/schema.h>

#include <string>

namespace console {

/// Each field of a payload with its type, unit, range and help; a payload that is no structure is
/// one row.
Table FieldsOf(const tendon::Schema& schema);

/// A value of the type as JSON, to be copied and changed: zeroes, or what is nearest to them in a
/// field's range.
std::string JsonSkeleton(const tendon::Schema& schema);

}  // namespace console
