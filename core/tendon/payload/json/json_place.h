#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tendon {

/// Returns the place in JSON text where the member or element named by `path` begins: "line 12,
/// column 5" for "processes[0].name". If the path does not exist, returns the place of its deepest
/// part that exists. The text after the returned place need not be JSON.
[[nodiscard]] std::string PlaceInJson(std::string_view text, std::string_view path);

/// Like PlaceInJson(), but for the second member that has the last name of `path` in the same
/// object.
[[nodiscard]] std::string PlaceOfSecondInJson(std::string_view text, std::string_view path);

/// Returns "line 12, column 5" for an offset in bytes.
[[nodiscard]] std::string LineAndColumn(std::string_view text, std::size_t offset);

}  // namespace tendon
