#pragma once

#include <tendon/base/result.h>

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace tendon {

class Schema;

/// Reads a value as a person types it: JSON, but a string or an enumerator needs no quotes, and
/// numbers are read as by ReadNumberLiteral(). The error, kInvalid, begins with the name of the
/// value, `name`, and says what to write.
///
/// Does not check that the value fits the type; FromJson() does this later. A duration whose
/// nanoseconds a double cannot hold becomes a string of its digits, which FromJson() reads to the
/// nanosecond.
Result<nlohmann::ordered_json> TypedValue(const Schema& schema, const std::string& name,
                                          const std::string& typed);

/// Converts JSON of this type for programs that read numbers as doubles. A duration whose
/// nanoseconds no double can hold becomes a string of its digits, which FromJson() reads to the
/// nanosecond. Members that the type does not have are not changed. Text that is not JSON is
/// returned unchanged.
[[nodiscard]] std::string WithExactDurations(const Schema& schema, const std::string& json);

}  // namespace tendon
