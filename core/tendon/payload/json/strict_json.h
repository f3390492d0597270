#pragma once

#include <tendon/base/result.h>

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace tendon {

using Json = nlohmann::json;

/// Maps the places of numbers, such as "path.times[0]", to the digits of the numbers.
using FineNumbers = std::map<std::string, std::string>;

/// Reads JSON that a person wrote. Fails with kInvalid for a grammar mistake ("line 12, column 5:
/// unexpected ','"), a duplicate key ("line 3, column 9: processes[0]: key 'name' occurs twice"),
/// nesting deeper than 64, a number that no double holds or that would become 0, a byte-order mark,
/// and empty text. The program's locale has no influence.
Result<Json> ParseStrictJson(std::string_view text);

/// Like ParseStrictJson(), but for values of a known type. A number with an integer value becomes
/// an integer, even if it is written as 2.0 or 1e3. A number that is not exactly an integer never
/// becomes one: 1.00000000000000000001 becomes a double. If `fine` is not null, it receives the
/// digits of each number for which IsFinerThanDouble() is true.
Result<Json> ParseExactJson(std::string_view text, FineNumbers* fine);

/// Reads JSON that a program wrote, perhaps another process; members keep their order. Fails like
/// ParseStrictJson(). The limit of nesting also applies here, because recursive code that reads the
/// value needs stack for each level.
Result<nlohmann::ordered_json> ParseOrderedJson(std::string_view text);

/// Like ParseOrderedJson(), but text that is not JSON, or is nested too deeply, becomes a string.
[[nodiscard]] nlohmann::ordered_json JsonOrText(std::string_view text);

/// Returns the kind of a value in words for people: "text", "number", "a list", ...
[[nodiscard]] std::string KindOf(const Json& value);

}  // namespace tendon
