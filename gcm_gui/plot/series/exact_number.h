#pragma once

#include <QString>
#include <bit>
#include <cmath>
#include <cstdint>

namespace tendon::gui {

/// A number exactly as its source wrote it: a double, or an integer with all 64 bits.
///
/// Beyond 2^53, doubles cannot distinguish neighbouring integers. A counter of nanoseconds is far
/// above 2^53. Therefore a sample keeps the number itself. A plot draws only the distance of the
/// number from a nearby base; a double holds this distance exactly.
class ExactNumber {
 public:
  enum class Kind : std::uint8_t { kReal, kSigned, kUnsigned };

  constexpr ExactNumber() = default;
  // Implicit, because the conversion of a double loses nothing.
  constexpr ExactNumber(double real)  // NOLINT(google-explicit-constructor)
      : word_(std::bit_cast<std::uint64_t>(real)) {}
  constexpr ExactNumber(Kind kind, std::uint64_t word) : word_(word), kind_(kind) {}
  static constexpr ExactNumber Signed(std::int64_t integer) {
    return {Kind::kSigned, static_cast<std::uint64_t>(integer)};
  }
  static constexpr ExactNumber Unsigned(std::uint64_t integer) {
    return {Kind::kUnsigned, integer};
  }

  [[nodiscard]] constexpr Kind kind() const { return kind_; }
  /// Returns the 64 bits. Their meaning depends on the kind.
  [[nodiscard]] constexpr std::uint64_t word() const { return word_; }
  [[nodiscard]] constexpr bool isInteger() const { return kind_ != Kind::kReal; }
  /// Returns the nearest double.
  [[nodiscard]] constexpr double nearest() const {
    switch (kind_) {
      case Kind::kSigned:
        return static_cast<double>(static_cast<std::int64_t>(word_));
      case Kind::kUnsigned:
        return static_cast<double>(word_);
      default:
        return std::bit_cast<double>(word_);
    }
  }
  [[nodiscard]] bool isFinite() const { return isInteger() || std::isfinite(nearest()); }
  /// Returns true if this number is less than `other`, which must be of the same kind.
  [[nodiscard]] constexpr bool isBelow(const ExactNumber& other) const {
    if (kind_ == Kind::kUnsigned) return word_ < other.word_;
    if (kind_ == Kind::kReal) return nearest() < other.nearest();
    return static_cast<std::int64_t>(word_) < static_cast<std::int64_t>(other.word_);
  }
  /// Returns all digits, so that parsing the text gives the same number.
  [[nodiscard]] QString text() const;

  bool operator==(const ExactNumber&) const = default;

 private:
  std::uint64_t word_ = 0;  // these bits are also the word of 0.0
  Kind kind_ = Kind::kReal;
};

/// Returns the exact difference of two integers of the same kind: "-3", "18446744073709551615".
[[nodiscard]] QString DifferenceText(const ExactNumber& from, const ExactNumber& to);

/// Computes the distance of numbers of one kind, given as words, from a base. For integers, the
/// base must be a whole number. The result is exact if a double can represent the distance.
class DistanceFrom {
 public:
  DistanceFrom(ExactNumber::Kind kind, double base);

  [[nodiscard]] double operator()(std::uint64_t word) const {
    if (!is_exact_) return ExactNumber(kind_, word).nearest() - base_;
    if (is_beyond_) {
      constexpr double kAll = 18446744073709551616.0;  // 2^64
      return word == whole_base_ ? -kAll : -static_cast<double>(whole_base_ - word);
    }
    const bool is_above =
        kind_ == ExactNumber::Kind::kUnsigned
            ? word >= whole_base_
            : static_cast<std::int64_t>(word) >= static_cast<std::int64_t>(whole_base_);
    return is_above ? static_cast<double>(word - whole_base_)
                    : -static_cast<double>(whole_base_ - word);
  }

 private:
  ExactNumber::Kind kind_;
  double base_;
  std::uint64_t whole_base_ = 0;
  bool is_exact_ = false;  // numbers and base are integers
  // the base is 2^63 or 2^64; as doubles, the largest integers become this base
  bool is_beyond_ = false;
};

}  // namespace tendon::gui
