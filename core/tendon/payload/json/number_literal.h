#pragma once

#include <tendon/payload/schema.h>

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// The reason why a word is not a number of its type.
enum class NumberFlaw {
  kNone,
  kEmpty,
  kDecimalComma,  ///< "0,5", "1.234,5"
  kGroups,        ///< "1'000", "1,234.5"
  kSpelling,      ///< "007", "0x10", "Infinity", digits or signs of another script
  kRest,          ///< "5deg": something follows the number
  kFraction,      ///< "1.5" for an integer
  kLimits,        ///< the type cannot hold this number
  kNoNumber,
};

/// The number that a person wrote, or the reason why the text is not a number.
struct NumberLiteral {
  std::string json;  ///< the number in JSON; empty if there is a flaw
  NumberFlaw flaw = NumberFlaw::kNone;
  /// Possible meanings, in JSON: several if the word is ambiguous, none if any meaning would be a
  /// guess.
  std::vector<std::string> meant;
  std::string rest;  ///< for kRest: the text after the number
};

/// True if a value of this kind is written as one number: integers, floats and durations.
[[nodiscard]] bool IsWrittenAsNumber(Schema::Kind kind);

/// Reads a number that a person typed; IsWrittenAsNumber(kind) must be true. In every locale, the
/// decimal sign is a point, and nothing separates thousands. In addition to JSON, accepts words
/// that can mean only one number: "+1", ".5", "5.", a number with blanks around it, and, if the
/// type has them, inf, -inf and nan. The value changes only by rounding to the type.
[[nodiscard]] NumberLiteral ReadNumberLiteral(Schema::Kind kind, std::string_view typed);

/// Converts a JSON number of seconds to nanoseconds, rounded. It reads the digits, because a double
/// is too coarse for the seconds since 1970. Empty if the text is not a number, or if the number is
/// 68 years or more.
[[nodiscard]] std::optional<std::chrono::nanoseconds> NanosecondsIn(std::string_view seconds);

/// True if a double cannot hold this number of seconds to the nanosecond.
[[nodiscard]] bool IsFinerThanDouble(std::string_view seconds);

/// Describes the flaw and its remedy: "write 0.5: use a point as the decimal sign". Empty if there
/// is no flaw.
[[nodiscard]] std::string FlawText(const NumberLiteral& word);

}  // namespace tendon
