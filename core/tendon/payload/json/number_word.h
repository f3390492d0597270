#pragma once

#include <tendon/payload/schema.h>

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// Why a word is no number of its type.
enum class NumberFlaw {
  kNone,
  kEmpty,
  kDecimalComma,  ///< "0,5", "1.234,5"
  kGroups,        ///< "1'000", "1,234.5"
  kSpelling,      ///< "007", "0x10", "Infinity", digits or signs of another script
  kRest,          ///< "5deg": something follows the number
  kFraction,      ///< "1.5" for an integer
  kLimits,        ///< the type holds no such number
  kNoNumber,
};

/// What a person wrote for a number: the number, or why it is none.
struct NumberWord {
  std::string json;  ///< the number in JSON; empty where there is a flaw
  NumberFlaw flaw = NumberFlaw::kNone;
  /// What may have been meant, in JSON: several where the word is ambiguous, none where a guess
  /// would be one.
  std::vector<std::string> meant;
  std::string rest;  ///< of kRest: what follows the number
};

/// Whether values of that kind are written as one number: integers, floats and durations.
[[nodiscard]] bool IsWrittenAsNumber(Schema::Kind kind);

/// Reads a number of a kind that IsWrittenAsNumber(), in every locale alike: a point is the decimal
/// sign, and nothing stands between thousands. Beyond JSON it takes what can mean one number only:
/// "+1", ".5", "5.", blanks around it, and, where the type has them, inf, -inf and nan. The number
/// is never another one than that written, but for what rounding to the type takes.
[[nodiscard]] NumberWord ReadNumberWord(Schema::Kind kind, std::string_view typed);

/// The nanoseconds of a JSON number of seconds, rounded, from its digits: a double has too few of
/// them for the seconds since 1970. Nothing where it is no number, or 68 years and more.
[[nodiscard]] std::optional<std::chrono::nanoseconds> NanosecondsIn(std::string_view seconds);

/// Whether that JSON number of seconds has other nanoseconds as a double.
[[nodiscard]] bool IsFinerThanDouble(std::string_view seconds);

/// What is wrong, and what to write: "write 0.5: the decimal sign is a point". Empty where nothing
/// is.
[[nodiscard]] std::string FlawText(const NumberWord& word);

}  // namespace tendon
