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

/// Reads JSON that a program wrote, perhaps that of another process; members keep their order.
/// Errors of code kInvalid as ParseStrictJson(), which also allows for no deeper nesting: whoever
/// walks over the value needs a stack for it.
Result<nlohmann::ordered_json> ParseOrderedJson(std::string_view text);

/// The same; what is no JSON, or nested deeper, is the text itself as a string.
[[nodiscard]] nlohmann::ordered_json JsonOrText(std::string_view text);

/// "text", "number", "list", ...: what a person calls the value.
[[nodiscard]] std::string KindOf(const Json& value);

}  // namespace tendon
