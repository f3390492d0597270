#pragma once

#include <string>
#include <string_view>

namespace tendon {

/// The place in JSON text where the member or element named by `path` begins: "line 12, column 5"
/// for "processes[0].name". If it does not exist, the place of the deepest part of the path that
/// exists. The text must be JSON only up to there.
[[nodiscard]] std::string PlaceInJson(std::string_view text, std::string_view path);

/// The same for the second member with the same name in an object.
[[nodiscard]] std::string PlaceOfSecondInJson(std::string_view text, std::string_view path);

/// "line 12, column 5" for an offset in bytes.
[[nodiscard]] std::string LineAndColumn(std::string_view text, std::size_t offset);

}  // namespace tendon
