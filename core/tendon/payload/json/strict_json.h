#pragma once

#include <tendon/base/result.h>

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace tendon {

using Json = nlohmann::json;

/// Reads JSON that a person wrote. Errors of code kInvalid for a mistake in the grammar ("line 12,
/// column 5: unexpected ','"), a key that occurs twice ("line 3, column 9: processes[0]: key 'name'
/// occurs twice"), nesting deeper than 64, a number that no double holds, a byte-order mark, and
/// for no text at all.
Result<Json> ParseStrictJson(std::string_view text);

/// "text", "number", "list", ...: what a person calls the value.
[[nodiscard]] std::string KindOf(const Json& value);

}  // namespace tendon
