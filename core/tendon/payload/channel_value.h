#pragma once

#include <tendon/payload/cdr.h>
#include <tendon/payload/schema.h>

#include <bit>
#include <concepts>
#include <cstdint>
#include <string>

namespace tendon {

/// One number of a payload, exactly as it came. A double holds no integer beyond 2^53 and no
/// nanosecond of a duration beyond 104 days, so neither goes through one here.
class ChannelValue {
 public:
  enum class Kind : std::uint8_t { kFloat32, kFloat64, kSigned, kUnsigned, kDuration };

  ChannelValue() = default;
  explicit ChannelValue(float value)
      : kind_(Kind::kFloat32), bits_(std::bit_cast<std::uint32_t>(value)) {}
  explicit ChannelValue(double value)
      : kind_(Kind::kFloat64), bits_(std::bit_cast<std::uint64_t>(value)) {}
  /// An enum's value, too; a bool is 0 or 1.
  template <std::integral Integer>
  explicit ChannelValue(Integer value)
      : kind_(std::signed_integral<Integer> ? Kind::kSigned : Kind::kUnsigned),
        bits_(static_cast<std::uint64_t>(value)) {}
  explicit ChannelValue(payload::CdrDuration duration);

  [[nodiscard]] Kind kind() const { return kind_; }
  /// Whether it is a float, which may be infinite or no number.
  [[nodiscard]] bool is_real() const { return kind_ == Kind::kFloat32 || kind_ == Kind::kFloat64; }
  /// The nearest double; of a duration in seconds.
  [[nodiscard]] double real() const;
  /// Of an integer or, in nanoseconds, of a duration. A kUnsigned beyond its range wraps around.
  [[nodiscard]] std::int64_t integer() const { return static_cast<std::int64_t>(bits_); }
  /// This one less `other`, of the same channel: exact for integers and durations up to the one
  /// rounding at the end. Infinite where no double holds it.
  [[nodiscard]] double Minus(const ChannelValue& other) const;

  /// Whether they are the same bits: not-a-number is equal to itself, and -0 differs from 0.
  bool operator==(const ChannelValue&) const = default;

 private:
  Kind kind_ = Kind::kFloat64;
  std::uint64_t bits_ = 0;
};

/// All of it, in the shortest form that reads back as the same: "18446744073709551615", "0.1",
/// "1e-300", "-0", "nan", "inf", "-inf", "-1.000000001" for a duration in seconds.
[[nodiscard]] std::string ToString(const ChannelValue& value);

/// As the type of its channel names it: "true", "false", the name of an enumerator; else
/// ToString().
[[nodiscard]] std::string ToString(const Schema& schema, const ChannelValue& value);

/// Whether values of this type are states or counts, which hold until the next one: bools, enums
/// and integers. A line between two of them would show values that never were.
[[nodiscard]] bool IsStepped(const Schema& schema);

}  // namespace tendon
