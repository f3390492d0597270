#pragma once

#include <QString>
#include <bit>
#include <cmath>
#include <cstdint>

namespace tendon::gui {

/// One number as its source wrote it: a double, or an integer with all its 64 bits.
///
/// Doubles cannot tell neighbouring integers apart from 2^53 on, which counters of nanoseconds are
/// far beyond. Samples therefore keep the number itself, and what is drawn is its distance from a
/// base nearby, which a double holds exactly.
class ExactNumber {
 public:
  enum class Kind : std::uint8_t { kReal, kSigned, kUnsigned };

  constexpr ExactNumber() = default;
  // Implicit, because a double is a number with nothing lost.
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
  /// Its 64 bits, as the kind means them.
  [[nodiscard]] constexpr std::uint64_t word() const { return word_; }
  [[nodiscard]] constexpr bool isInteger() const { return kind_ != Kind::kReal; }
  /// The nearest double.
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
  /// Whether it is less than another of the same kind.
  [[nodiscard]] constexpr bool isBelow(const ExactNumber& other) const {
    if (kind_ == Kind::kUnsigned) return word_ < other.word_;
    if (kind_ == Kind::kReal) return nearest() < other.nearest();
    return static_cast<std::int64_t>(word_) < static_cast<std::int64_t>(other.word_);
  }
  /// All its digits, so that it is read as the same.
  [[nodiscard]] QString text() const;

  bool operator==(const ExactNumber&) const = default;

 private:
  std::uint64_t word_ = 0;  // of 0.0, too
  Kind kind_ = Kind::kReal;
};

/// The difference of two integers of one kind, exactly: "-3", "18446744073709551615".
[[nodiscard]] QString DifferenceText(const ExactNumber& from, const ExactNumber& to);

/// How far the words of one kind are from a base, which is a whole number where they are integers.
/// Exact where the distance fits a double.
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
  bool is_exact_ = false;   // integers on both sides
  bool is_beyond_ = false;  // the base is the one above all integers: the largest ones round to it
};

}  // namespace tendon::gui
