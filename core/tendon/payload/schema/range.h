#pragma once

#include <tendon/payload/describe.h>

#include <string>
#include <string_view>

/// Ranges as text: "0 to 2.5", "-inf to 10".
namespace tendon::payload {

[[nodiscard]] std::string ToString(const Range& range);

/// Reads a range, as ToString() prints it, from the front of `text` and removes it there. Returns
/// false if there is no range; even then, a part of `text` may have been removed.
[[nodiscard]] bool ReadRange(std::string_view& text, Range& range);

}  // namespace tendon::payload
