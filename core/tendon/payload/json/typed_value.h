#pragma once

#include <tendon/base/result.h>

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace tendon {

class Schema;

/// What a person types for a value of that type: JSON, where a text or the name of an enumerator
/// needs no quotes, and a number is read as ReadNumberWord() does. The error, kInvalid, begins with
/// `name`, which the value is called by, and says what to write. Whether the value fits the type
/// FromJson() says. A duration whose nanoseconds a double does not hold is its digits as a string,
/// which FromJson() reads to the nanosecond.
Result<nlohmann::ordered_json> TypedValue(const Schema& schema, const std::string& name,
                                          const std::string& typed);

/// JSON of the type for those who read numbers as doubles: a duration whose nanoseconds no double
/// holds becomes its digits as a string, which FromJson() reads to the nanosecond. Members that the
/// type does not have are left alone; text that is no JSON is returned as it is.
[[nodiscard]] std::string WithExactDurations(const Schema& schema, const std::string& json);

}  // namespace tendon
