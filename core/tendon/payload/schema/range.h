#pragma once

#include <tendon/payload/description.h>

#include <string>
#include <string_view>

/// Ranges as text: "0 to 2.5", "-inf to 10".
namespace tendon::payload {

[[nodiscard]] std::string ToString(const Range& range);

/// Reads what ToString() prints off the front of `text`. False, with `text` somewhere behind its
/// first letter that does not fit, when there is none.
[[nodiscard]] bool ReadRange(std::string_view& text, Range& range);

}  // namespace tendon::payload
