#pragma once

#include <tendon/base/result.h>

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace tendon {

using Json = nlohmann::json;

/// The digits of numbers by their places, such as "path.times[0]".
using FineNumbers = std::map<std::string, std::string>;

/// Reads JSON that a person wrote. Errors of code kInvalid for a mistake in the grammar ("line 12,
/// column 5: unexpected ','"), a key that occurs twice ("line 3, column 9: processes[0]: key 'name'
/// occurs twice"), nesting deeper than 64, a number that no double holds, one that would become 0,
/// a byte-order mark, and for no text at all. The program's locale changes nothing.
Result<Json> ParseStrictJson(std::string_view text);

/// The same, for values whose type is known: a number that is an integer is read as one however it
/// is written (2.0, 1e3), and no other, so that 1.00000000000000000001 is not taken for 1. Numbers
/// that IsFinerThanDouble() holds of as seconds are kept in `fine`, unless that is null.
Result<Json> ParseExactJson(std::string_view text, FineNumbers* fine);

/// Reads JSON that a program wrote, perhaps that of another process; members keep their order.
/// Errors of code kInvalid as ParseStrictJson(), which also allows for no deeper nesting: whoever
/// walks over the value needs a stack for it.
Result<nlohmann::ordered_json> ParseOrderedJson(std::string_view text);

/// The same; what is no JSON, or nested deeper, is the text itself as a string.
[[nodiscard]] nlohmann::ordered_json JsonOrText(std::string_view text);

/// "text", "number", "list", ...: what a person calls the value.
[[nodiscard]] std::string KindOf(const Json& value);

}  // namespace tendon
