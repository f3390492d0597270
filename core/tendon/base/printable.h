#pragma once

#include <string>
#include <string_view>

namespace tendon {

/// Text of any origin, made safe for a terminal and a log: at most `most` bytes of it, "..." behind
/// where it was cut; control characters and bytes that are no UTF-8 as `\xNN`.
[[nodiscard]] std::string Printable(std::string_view text, std::size_t most = 4096);

}  // namespace tendon
