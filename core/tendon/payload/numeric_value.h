#pragma once

#include <tendon/payload/cdr.h>
#include <tendon/payload/schema.h>

#include <bit>
#include <concepts>
#include <cstdint>
#include <string>

namespace tendon {

/// One number of a payload, with its exact value. Integers and durations are not stored as doubles,
/// because a double cannot hold all integers beyond 2^53, or the nanoseconds of durations beyond
/// 104 days.
class NumericValue {
 public:
  enum class Kind : std::uint8_t { kFloat32, kFloat64, kSigned, kUnsigned, kDuration };

  NumericValue() = default;
  explicit NumericValue(float value)
      : kind_(Kind::kFloat32), bits_(std::bit_cast<std::uint32_t>(value)) {}
  explicit NumericValue(double value)
      : kind_(Kind::kFloat64), bits_(std::bit_cast<std::uint64_t>(value)) {}
  /// For an integer, the value of an enum, or a bool, which becomes 0 or 1.
  template <std::integral Integer>
  explicit NumericValue(Integer value)
      : kind_(std::signed_integral<Integer> ? Kind::kSigned : Kind::kUnsigned),
        bits_(static_cast<std::uint64_t>(value)) {}
  explicit NumericValue(payload::CdrDuration duration);

  [[nodiscard]] Kind kind() const { return kind_; }
  /// True for a float, which may be infinite or not-a-number.
  [[nodiscard]] bool is_real() const { return kind_ == Kind::kFloat32 || kind_ == Kind::kFloat64; }
  /// Returns the nearest double; for a duration, its seconds.
  [[nodiscard]] double real() const;
  /// Returns the integer, or the nanoseconds of a duration. A kUnsigned that an int64 cannot hold
  /// wraps around.
  [[nodiscard]] std::int64_t integer() const { return static_cast<std::int64_t>(bits_); }

  /// True if the bits are equal: not-a-number equals itself, and -0 differs from 0.
  bool operator==(const NumericValue&) const = default;

 private:
  Kind kind_ = Kind::kFloat64;
  std::uint64_t bits_ = 0;
};

/// Converts a number to its shortest text that is read back as the same number:
/// "18446744073709551615", "0.1", "1e-300", "-0", "nan", "inf", "-inf", "-1.000000001" for a
/// duration in seconds.
[[nodiscard]] std::string ToString(const NumericValue& value);

/// Converts a value of this type to text. A bool becomes "true" or "false", and an enum value
/// becomes the name of its enumerator. All other values are converted by ToString(value).
[[nodiscard]] std::string ToString(const Schema& schema, const NumericValue& value);

/// True if values of this type are states or counts: bools, enums and integers. A plot must draw
/// them as steps, because a sloped line between two values would show values that never existed.
[[nodiscard]] bool IsStepped(const Schema& schema);

}  // namespace tendon
