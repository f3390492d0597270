#include <tendon/base/text.h>

#include <cstddef>

namespace tendon {
namespace {

bool Continues(std::string_view text, std::size_t at) {
  return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0U) == 0x80U;
}

/// Returns the length of the UTF-8 character at the front of `text`; 0 if it is invalid, overlong
/// or a control character.
std::size_t CharacterLength(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const auto second = static_cast<unsigned char>(text.size() > 1 ? text[1] : 0);
  std::size_t length = 0;
  if (first >= 0xc2 && first < 0xe0) {
    length = first == 0xc2 && second < 0xa0 ? 0 : 2;  // U+0080 to U+009F are control characters
  } else if (first >= 0xe0 && first < 0xf0) {
    const bool surrogate = first == 0xed && second >= 0xa0;
    length = (first == 0xe0 && second < 0xa0) || surrogate ? 0 : 3;
  } else if (first >= 0xf0 && first < 0xf5) {
    const bool outside = (first == 0xf0 && second < 0x90) || (first == 0xf4 && second >= 0x90);
    length = outside ? 0 : 4;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if (!Continues(text, i)) return 0;
  }
  return length;
}

}  // namespace

std::string Printable(std::string_view text, std::size_t most) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string out;
  while (!text.empty() && out.size() < most) {
    if (const std::size_t length = CharacterLength(text); length > 0) {
      out += text.substr(0, length);
      text.remove_prefix(length);
      continue;
    }
    const auto byte = static_cast<unsigned char>(text[0]);
    out += {'\\', 'x', kHex[byte >> 4U], kHex[byte & 0xfU]};
    text.remove_prefix(1);
  }
  return text.empty() ? out : out + "...";
}

std::string InLowerCase(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return lower;
}

}  // namespace tendon
