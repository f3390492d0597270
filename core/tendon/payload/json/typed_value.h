#pragma once

#include <tendon/base/result.h>

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace tendon {

class Schema;

/// Reads a value of that type as a person types it: JSON, but a text or the name of an enumerator
/// needs no quotes, and a number is read like ReadNumberWord(). The error, kInvalid, begins with
/// `name`, the name of the value, and tells what to write. FromJson() checks if the value fits the
/// type. A duration whose nanoseconds a double cannot hold becomes a string of its digits, which
/// FromJson() reads to the nanosecond.
Result<nlohmann::ordered_json> TypedValue(const Schema& schema, const std::string& name,
                                          const std::string& typed);

/// JSON of the type for those who read numbers as doubles: a duration whose nanoseconds no double
/// holds becomes its digits as a string, which FromJson() reads to the nanosecond. Members that the
/// type does not have are left alone; text that is no JSON is returned as it is.
[[nodiscard]] std::string WithExactDurations(const Schema& schema, const std::string& json);

}  // namespace tendon
