#pragma once

#include <string>
#include <string_view>

namespace tendon {

/// Makes untrusted text safe for a terminal and a log: at most `most` bytes of it, with "..." after
/// a cut; control characters and invalid UTF-8 become `\xNN`.
[[nodiscard]] std::string Printable(std::string_view text, std::size_t most = 4096);

/// The text in lower case. Converts only ASCII letters, whatever the locale.
[[nodiscard]] std::string InLowerCase(std::string_view text);

}  // namespace tendon
