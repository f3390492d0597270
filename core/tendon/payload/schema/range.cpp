#include <tendon/payload/schema/range.h>

#include <array>
#include <charconv>

namespace tendon::payload {
namespace {

constexpr std::string_view kTo = " to ";

std::string NumberText(double number) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

bool ReadNumber(std::string_view& text, double& number) {
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return code == std::errc{};
}

}  // namespace

std::string ToString(const Range& range) {
  return NumberText(range.lowest) + std::string(kTo) + NumberText(range.highest);
}

bool ReadRange(std::string_view& text, Range& range) {
  if (!ReadNumber(text, range.lowest) || !text.starts_with(kTo)) return false;
  text.remove_prefix(kTo.size());
  return ReadNumber(text, range.highest) && IsRange(range);
}

}  // namespace tendon::payload
