#include <tendon/payload/json/number_literal.h>

#include <tendon/base/text.h>
#include <tendon/payload/body_reader.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace tendon {
namespace {

using Kind = Schema::Kind;

constexpr char kGroupSign = '\'';
constexpr std::string_view kDigits = "0123456789";

bool IsDigit(char letter) { return letter >= '0' && letter <= '9'; }

/// The parts of a number as it is written. The digits on one side of the point may be missing.
struct Spelling {
  bool is_negative = false;
  std::string whole;
  std::string fraction;
  std::string exponent;  // with its sign
};

/// Removes the leading digits from `text` and returns them.
std::string TakeDigits(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_not_of(kDigits), text.size());
  std::string digits(text.substr(0, end));
  text.remove_prefix(end);
  return digits;
}

bool TakeLetter(std::string_view& text, std::string_view letters) {
  if (text.empty() || letters.find(text.front()) == letters.npos) return false;
  text.remove_prefix(1);
  return true;
}

/// Removes the longest leading number from `text` and returns it, if the text begins with a number.
std::optional<Spelling> TakeNumber(std::string_view& text) {
  std::string_view rest = text;
  Spelling number;
  number.is_negative = rest.starts_with('-');
  TakeLetter(rest, "+-");
  number.whole = TakeDigits(rest);
  if (TakeLetter(rest, ".")) number.fraction = TakeDigits(rest);
  if (number.whole.empty() && number.fraction.empty()) return std::nullopt;
  text = rest;
  if (!TakeLetter(rest, "eE")) return number;
  number.exponent = rest.starts_with('-') ? "-" : "";
  TakeLetter(rest, "+-");
  const std::string digits = TakeDigits(rest);
  number.exponent = digits.empty() ? "" : number.exponent + digits;
  if (!digits.empty()) text = rest;
  return number;
}

std::optional<Spelling> WholeNumber(std::string_view text) {
  auto number = TakeNumber(text);
  return text.empty() ? number : std::nullopt;
}

/// Returns the number in JSON form: without leading zeros, and with digits on both sides of a
/// point.
std::string JsonOf(const Spelling& number) {
  std::string whole =
      number.whole.substr(std::min(number.whole.find_first_not_of('0'), number.whole.size()));
  if (whole.empty()) whole = "0";
  std::string json = (number.is_negative ? "-" : "") + whole;
  if (!number.fraction.empty()) json += "." + number.fraction;
  return number.exponent.empty() ? json : json + "e" + number.exponent;
}

bool HasZerosInFront(const Spelling& number) {
  return number.whole.size() > 1 && number.whole.front() == '0';
}

/// Returns the letter at an offset of UTF-8 text, and its size in bytes. An invalid letter becomes
/// 0xfffd.
std::pair<char32_t, std::size_t> LetterAt(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
  const std::size_t size = byte(0) < 0x80 ? 1 : byte(0) < 0xe0 ? 2 : byte(0) < 0xf0 ? 3 : 4;
  if (size == 1) return {byte(0), 1};
  if (at + size > text.size() || byte(0) < 0xc0) return {0xfffd, 1};
  char32_t letter = byte(0) & (0xffU >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) letter = letter << 6U | (byte(i) & 0x3fU);
  return {letter, size};
}

/// Returns the ASCII character with the same meaning in a number; 0 if no character has it.
char InAscii(char32_t letter) {
  constexpr auto kZeros = std::to_array<char32_t>({0x660, 0x6f0, 0x966, 0x9e6, 0xff10});
  for (const char32_t zero : kZeros) {
    if (letter >= zero && letter < zero + 10) return static_cast<char>('0' + (letter - zero));
  }
  switch (letter) {
    case 0xff0e:  // full-width point
      return '.';
    case 0x66b:  // Arabic decimal sign
    case 0xff0c:
      return ',';
    case 0x2212:  // minus
    case 0x2013:  // dash
    case 0xff0d:
      return '-';
    case 0xff0b:
      return '+';
    case 0xa0:  // blanks and marks between thousands
    case 0x202f:
    case 0x2009:
    case 0x2019:
    case 0x66c:
      return kGroupSign;
    default:
      return 0;
  }
}

/// Returns the text, with every letter that has an ASCII equivalent replaced by it.
std::string AsciiOf(std::string_view text) {
  std::string ascii;
  for (std::size_t at = 0; at < text.size();) {
    const auto [letter, size] = LetterAt(text, at);
    const char same = letter < 0x80 ? static_cast<char>(letter) : InAscii(letter);
    ascii += same == 0 ? std::string(text.substr(at, size)) : std::string(1, same);
    at += size;
  }
  return ascii;
}

std::string Trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t begin = std::min(text.find_first_not_of(kBlanks), text.size());
  const std::size_t end = text.find_last_not_of(kBlanks);
  return std::string(end == text.npos ? "" : text.substr(begin, end + 1 - begin));
}

/// Returns the JSON word for infinity or not-a-number: "inf" for "+Infinity". Returns an empty text
/// for all other input.
std::string NotFinite(const std::string& text) {
  const std::string lower = InLowerCase(text);
  const bool is_signed = lower.starts_with('+') || lower.starts_with('-');
  const std::string name = lower.substr(is_signed ? 1 : 0);
  if (name == "nan") return "nan";
  if (name != "inf" && name != "infinity") return "";
  return lower.starts_with('-') ? "-inf" : "inf";
}

/// True if `whole` has digits grouped by `sign`: one to three digits without a leading zero, then
/// groups of three.
bool IsGrouped(std::string_view whole, char sign) {
  if (whole.starts_with('0')) return false;
  std::size_t digits = 0;
  bool is_first = true;
  for (const char letter : whole) {
    if (IsDigit(letter)) {
      ++digits;
      continue;
    }
    if (letter != sign || digits == 0 || digits > 3 || (!is_first && digits != 3)) return false;
    is_first = false;
    digits = 0;
  }
  return !is_first && digits == 3;
}

std::string Without(std::string text, char sign) {
  std::erase(text, sign);
  return text;
}

/// Returns the number as JSON, without the `group` signs and with a point at the offset `decimal`,
/// which may be npos. Empty if the groups are malformed.
std::optional<std::string> Ungrouped(std::string text, std::size_t decimal, char group) {
  std::string front = text.substr(0, decimal);
  const std::string behind = decimal == text.npos ? "" : text.substr(decimal + 1);
  const std::size_t sign = front.starts_with('+') || front.starts_with('-') ? 1 : 0;
  const bool has_groups = front.find(group) != front.npos;
  if (has_groups && !IsGrouped(std::string_view(front).substr(sign), group)) return std::nullopt;
  front = Without(std::move(front), group);
  const auto number = WholeNumber(decimal == text.npos ? front : front + "." + behind);
  if (!number) return std::nullopt;
  return JsonOf(*number);
}

/// Returns the possible meanings of a word with commas, points, blanks or marks between its digits.
NumberLiteral ReadSeparated(const std::string& text) {
  NumberLiteral word{.json = {}, .flaw = NumberFlaw::kNoNumber, .meant = {}, .rest = {}};
  const auto add = [&word](NumberFlaw flaw, const std::optional<std::string>& meant) {
    if (!meant) return;
    if (word.meant.empty()) word.flaw = flaw;
    word.meant.push_back(*meant);
  };
  std::string plain = text;
  std::ranges::replace(plain, ' ', kGroupSign);
  std::ranges::replace(plain, '_', kGroupSign);
  const auto commas = std::ranges::count(plain, ',');
  const auto points = std::ranges::count(plain, '.');
  const std::size_t comma = plain.rfind(',');
  const std::size_t point = plain.rfind('.');
  const bool has_marks = plain.find(kGroupSign) != plain.npos;
  if (has_marks) {
    if (commas == 1 && points == 0) {
      add(NumberFlaw::kDecimalComma, Ungrouped(plain, comma, kGroupSign));
    } else if (commas == 0) {
      add(NumberFlaw::kGroups, Ungrouped(plain, point, kGroupSign));
    }
    return word;
  }
  if (commas == 1 && (points == 0 || point < comma)) {
    add(NumberFlaw::kDecimalComma, Ungrouped(plain, comma, '.'));
  }
  if (commas > 0 && points == 0) add(NumberFlaw::kGroups, Ungrouped(plain, plain.npos, ','));
  if (commas > 0 && points == 1 && comma < point) {
    add(NumberFlaw::kGroups, Ungrouped(plain, point, ','));
  }
  if (commas == 0 && points > 1) add(NumberFlaw::kGroups, Ungrouped(plain, plain.npos, '.'));
  return word;
}

/// Returns the decimal form of a hexadecimal number such as "0x1f"; nothing for other text.
std::optional<std::string> DecimalOfHex(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  TakeLetter(text, "+-");
  if (!text.starts_with("0x") && !text.starts_with("0X")) return std::nullopt;
  text.remove_prefix(2);
  std::uint64_t number = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
  if (code != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return (is_negative ? "-" : "") + std::to_string(number);
}

/// Returns the text after a number, such as "deg" in "5 deg". Returns an empty text if nothing
/// follows the number, or if `text` does not begin with a number.
std::string RestBehindNumber(std::string_view text) {
  const std::size_t end = text.find_first_not_of("+-0123456789.,_' ");
  if (end == text.npos || text.substr(0, end).find_first_of(kDigits) == text.npos) return "";
  return std::string(text.substr(end));
}

/// Returns the digits of an integer that may be written with a point or an exponent ("1.50e2").
/// Returns nothing if the number is not an integer. No type has more than `kMax` digits.
std::optional<std::string> IntegerDigits(const Spelling& number, bool& is_too_long) {
  constexpr int kMax = 40;
  std::string digits = number.whole + number.fraction;
  const std::size_t first = digits.find_first_not_of('0');
  if (first == digits.npos) return "0";
  int exponent = 0;
  const char* const end = number.exponent.data() + number.exponent.size();
  if (std::from_chars(number.exponent.data(), end, exponent).ec == std::errc::result_out_of_range) {
    is_too_long = !number.exponent.starts_with('-');
    return std::nullopt;
  }
  std::int64_t places = exponent - static_cast<std::int64_t>(number.fraction.size());
  for (; places < 0 && digits.ends_with('0'); ++places) digits.pop_back();
  if (places < 0) return std::nullopt;
  is_too_long = static_cast<std::int64_t>(digits.size() - first) + places > kMax;
  if (is_too_long) return std::nullopt;
  return digits.substr(first) + std::string(static_cast<std::size_t>(places), '0');
}

NumberLiteral FlawOf(NumberFlaw flaw, std::vector<std::string> meant = {}) {
  return {.json = {}, .flaw = flaw, .meant = std::move(meant), .rest = {}};
}

template <typename Integer>
NumberLiteral IntegerOf(const Spelling& number) {
  bool is_too_long = false;
  const auto digits = IntegerDigits(number, is_too_long);
  if (!digits) return FlawOf(is_too_long ? NumberFlaw::kLimits : NumberFlaw::kFraction);
  const std::string json = (number.is_negative && *digits != "0" ? "-" : "") + *digits;
  Integer held{};
  const auto [end, code] = std::from_chars(json.data(), json.data() + json.size(), held);
  if (code != std::errc() || end != json.data() + json.size()) return FlawOf(NumberFlaw::kLimits);
  return {.json = json, .flaw = NumberFlaw::kNone, .meant = {}, .rest = {}};
}

/// Refuses a number that would become infinite, and a number other than 0 that would become 0.
template <typename Real>
NumberLiteral RealOf(const Spelling& number) {
  std::string json = JsonOf(number);
  Real held{};
  const auto code = std::from_chars(json.data(), json.data() + json.size(), held).ec;
  const std::string mantissa = number.whole + number.fraction;
  const bool is_zero = mantissa.find_first_not_of('0') == mantissa.npos;
  if (!is_zero && (code != std::errc() || std::isinf(held) || held == 0)) {
    return FlawOf(NumberFlaw::kLimits);
  }
  if (is_zero && number.is_negative && number.fraction.empty() && number.exponent.empty()) {
    json += ".0";  // because JSON readers take -0 for the integer 0
  }
  return {.json = json, .flaw = NumberFlaw::kNone, .meant = {}, .rest = {}};
}

NumberLiteral DurationOf(const Spelling& number) {
  constexpr double kLimit = 2147483648.0;  // s
  NumberLiteral word = RealOf<double>(number);
  if (word.flaw != NumberFlaw::kNone) return word;
  double seconds = 0;
  std::from_chars(word.json.data(), word.json.data() + word.json.size(), seconds);
  const bool is_below_resolution = seconds != 0 && std::abs(seconds) < 0.5e-9;
  if (std::abs(seconds) >= kLimit || is_below_resolution) return FlawOf(NumberFlaw::kLimits);
  return word;
}

NumberLiteral OfKind(Kind kind, const Spelling& number) {
  if (kind == Kind::kDuration) return DurationOf(number);
  return payload::WithNumber(kind, [&](auto type) {
    using Number = decltype(type);
    if constexpr (std::is_same_v<Number, bool>) {
      return FlawOf(NumberFlaw::kNoNumber);
    } else if constexpr (std::is_floating_point_v<Number>) {
      return RealOf<Number>(number);
    } else {
      return IntegerOf<Number>(number);
    }
  });
}

bool HasInfinity(Kind kind) { return kind == Kind::kFloat32 || kind == Kind::kFloat64; }

/// Converts seconds, without their sign, to rounded nanoseconds. Returns nothing if the result is
/// `limit` or more.
std::optional<std::int64_t> Nanoseconds(const Spelling& seconds, std::int64_t limit) {
  constexpr int kPlaces = 9;
  const std::string digits = seconds.whole + seconds.fraction;
  if (digits.find_first_not_of('0') == digits.npos) return 0;
  int exponent = 0;
  const char* const last = seconds.exponent.data() + seconds.exponent.size();
  if (std::from_chars(seconds.exponent.data(), last, exponent).ec ==
      std::errc::result_out_of_range) {
    return seconds.exponent.starts_with('-') ? std::optional<std::int64_t>(0) : std::nullopt;
  }
  const std::int64_t end = static_cast<std::int64_t>(seconds.whole.size()) + exponent + kPlaces;
  const auto digit = [&](std::int64_t at) {
    return at < static_cast<std::int64_t>(digits.size())
               ? digits[static_cast<std::size_t>(at)] - '0'
               : 0;
  };
  std::int64_t count = 0;
  for (std::int64_t at = 0; at < end; ++at) {
    if (count > limit / 10) return std::nullopt;
    count = 10 * count + digit(at);
  }
  if (end >= 0 && digit(end) >= 5) ++count;
  return count < limit ? std::optional(count) : std::nullopt;
}

}  // namespace

bool IsWrittenAsNumber(Kind kind) {
  return (kind <= Kind::kFloat64 && kind != Kind::kBool) || kind == Kind::kDuration;
}

NumberLiteral ReadNumberLiteral(Kind kind, std::string_view typed) {
  const std::string text = Trimmed(typed);
  if (text.empty()) return FlawOf(NumberFlaw::kEmpty);
  const std::string ascii = Trimmed(AsciiOf(text));
  const auto number = WholeNumber(ascii);
  if (number && ascii == text && !HasZerosInFront(*number)) return OfKind(kind, *number);
  if (number) return FlawOf(NumberFlaw::kSpelling, {JsonOf(*number)});
  if (const std::string name = NotFinite(ascii); !name.empty()) {
    if (!HasInfinity(kind)) return FlawOf(NumberFlaw::kLimits);
    const bool is_spelled_so = text == name || text == "+" + name;
    if (!is_spelled_so) return FlawOf(NumberFlaw::kSpelling, {name});
    return {.json = '"' + name + '"', .flaw = NumberFlaw::kNone, .meant = {}, .rest = {}};
  }
  if (const auto decimal = DecimalOfHex(ascii)) return FlawOf(NumberFlaw::kSpelling, {*decimal});
  NumberLiteral word = ReadSeparated(ascii);
  if (word.flaw != NumberFlaw::kNoNumber) return word;
  if (std::string rest = RestBehindNumber(ascii); !rest.empty()) {
    word.flaw = NumberFlaw::kRest;
    word.rest = std::move(rest);
  }
  return word;
}

std::optional<std::chrono::nanoseconds> NanosecondsIn(std::string_view seconds) {
  constexpr std::int64_t kLimit = 2147483648 * 1'000'000'000;
  const auto number = WholeNumber(seconds);
  if (!number) return std::nullopt;
  const auto count = Nanoseconds(*number, kLimit);
  if (!count) return std::nullopt;
  return std::chrono::nanoseconds(number->is_negative ? -*count : *count);
}

bool IsFinerThanDouble(std::string_view seconds) {
  const auto exact = NanosecondsIn(seconds);
  double real = 0.0;
  const auto code = std::from_chars(seconds.data(), seconds.data() + seconds.size(), real).ec;
  constexpr double kInSecond = 1e9;
  return exact && code == std::errc() && std::llround(real * kInSecond) != exact->count();
}

std::string FlawText(const NumberLiteral& word) {
  std::string write;
  for (const std::string& one : word.meant) write += (write.empty() ? "write " : " or ") + one;
  switch (word.flaw) {
    case NumberFlaw::kNone:
      return {};
    case NumberFlaw::kEmpty:
      return "a number is missing";
    case NumberFlaw::kDecimalComma:
      return write + ": use a point as the decimal sign" +
             (word.meant.size() > 1 ? ", and no separator between thousands" : "");
    case NumberFlaw::kGroups:
      return write + ": use no separator between thousands";
    case NumberFlaw::kSpelling:
      return write;
    case NumberFlaw::kRest:
      return "write the number alone, without " + Quoted(word.rest, 40);
    case NumberFlaw::kFraction:
      return "write a whole number";
    case NumberFlaw::kLimits:
      return "the number is too large or too small for the type";
    case NumberFlaw::kNoNumber:
      return "write a number in digits";
  }
  return {};
}

}  // namespace tendon
