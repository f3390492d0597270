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
/// Does not check that the value fits the type; FromJson() does this later. If a double cannot hold
/// a duration exactly, the duration is returned as a string of digits. FromJson() reads this string
/// without loss.
Result<nlohmann::ordered_json> TypedValue(const Schema& schema, const std::string& name,
                                          const std::string& typed);

/// Converts JSON of this type for programs that read numbers as doubles. If a double cannot hold a
/// duration exactly, the duration is returned as a string of digits. FromJson() reads this string
/// without loss. Members that the type does not have are not changed. Text that is not JSON is
/// returned unchanged.
[[nodiscard]] std::string WithExactDurations(const Schema& schema, const std::string& json);

}  // namespace tendon
