#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace tendon::test {

/// A decimal number: the sign, the digits without zeros at either end, and the power of ten of the
/// last digit. Two words mean the same number if and only if these parts are equal. Tests compare
/// all code that reads numbers with this class, which shares no code with it.
struct WrittenNumber {
  bool is_negative = false;
  std::string digits;  // empty for 0
  std::int64_t power = 0;

  bool operator==(const WrittenNumber&) const = default;
};

/// Parses a decimal number. Returns nothing if the word is no number, or can be read as two
/// numbers.
inline std::optional<WrittenNumber> WrittenNumberOf(const std::string& word) {
  constexpr std::size_t kMaxOfExponent = 15;  // digits: no type holds more
  static const std::regex grammar(R"(([+-]?)(\d*)(?:\.(\d*))?(?:[eE]([+-]?)0*(\d*))?)");
  std::smatch parts;
  if (!std::regex_match(word, parts, grammar)) return std::nullopt;
  if (parts[2].length() + parts[3].length() == 0) return std::nullopt;
  WrittenNumber number{.is_negative = parts[1] == "-", .digits = parts[2].str() + parts[3].str()};
  if (parts[4].matched && parts[5].length() == 0 && !word.ends_with('0')) return std::nullopt;
  const std::string exponent = parts[5].str().substr(0, kMaxOfExponent);
  number.power = exponent.empty() ? 0 : std::stoll(parts[4].str() + exponent);
  number.power -= parts[3].length();
  while (number.digits.ends_with('0')) {
    number.digits.pop_back();
    ++number.power;
  }
  number.digits.erase(0, number.digits.find_first_not_of('0'));
  if (number.digits.empty()) return WrittenNumber{};
  return number;
}

/// Generates random words: valid and invalid numbers.
class RandomWords {
 public:
  explicit RandomWords(std::uint32_t seed) : random_(seed) {}

  std::string Next() {
    static const std::vector<std::string> parts{
        "0",      "1",      "5",      "7",      "12",
        "123",    "000",    "001",    "234",    "999999999999",
        ".",      ",",      ".",      ",",      "-",
        "+",      "e",      "E",      "e-",     "'",
        "_",      " ",      ";",      "deg",    " rad",
        "%",      "0x",     "inf",    "nan",    "\u00a0",
        "\u202f", "\u2212", "\uff11", "\u0663", "\u066b",
        "[",      "]",      "\t"};
    std::string word;
    for (std::size_t count = 1 + Below(6); count > 0; --count) word += parts[Below(parts.size())];
    return word;
  }
  std::size_t Below(std::size_t end) { return random_() % end; }

 private:
  std::mt19937 random_;
};

}  // namespace tendon::test
