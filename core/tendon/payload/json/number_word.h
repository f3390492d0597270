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

/// The number that a person wrote, or the reason why there is none.
struct NumberWord {
  std::string json;  ///< the number in JSON; empty if there is a flaw
  NumberFlaw flaw = NumberFlaw::kNone;
  /// Possible meanings, in JSON: several if the word is ambiguous, none if one would be a guess.
  std::vector<std::string> meant;
  std::string rest;  ///< of kRest: the text after the number
};

/// True if values of that kind are written as one number: integers, floats and durations.
[[nodiscard]] bool IsWrittenAsNumber(Schema::Kind kind);

/// Reads a number of a kind that IsWrittenAsNumber(), in the same way in every locale: the decimal
/// sign is a point, and nothing separates thousands. Beyond JSON it accepts words with only one
/// possible meaning: "+1", ".5", "5.", blanks around it, and, if the type has them, inf, -inf and
/// nan. The result is always the written number, apart from rounding to the type.
[[nodiscard]] NumberWord ReadNumberWord(Schema::Kind kind, std::string_view typed);

/// The nanoseconds of a JSON number of seconds, rounded, from its digits: a double is too coarse
/// for the seconds since 1970. Nothing if it is not a number, or 68 years and more.
[[nodiscard]] std::optional<std::chrono::nanoseconds> NanosecondsIn(std::string_view seconds);

/// True if that number of seconds has other nanoseconds as a double.
[[nodiscard]] bool IsFinerThanDouble(std::string_view seconds);

/// Tells the flaw and what to write: "write 0.5: the decimal sign is a point". Empty without a
/// flaw.
[[nodiscard]] std::string FlawText(const NumberWord& word);

}  // namespace tendon
