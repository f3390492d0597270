#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

/// Computes axes of numbers for a window, a terminal or a page: the range of an axis, and the
/// positions and texts of its labels. All functions are pure, work for every finite double and
/// every 64-bit integer, and give finite results.
namespace tendon {

/// The lower and the upper end of an axis.
template <typename Number>
struct AxisSpan {
  Number low{};
  Number high{};

  bool operator==(const AxisSpan&) const = default;
};

/// A position on an axis and the text of its label.
template <typename Number>
struct AxisTick {
  Number value{};
  std::string label;

  bool operator==(const AxisTick&) const = default;
};

template <typename Number>
concept AxisNumber = std::same_as<Number, double> || std::same_as<Number, std::int64_t> ||
    std::same_as<Number, std::uint64_t>;

/// A value whose absolute value is below this counts as 0 with a rounding error.
inline constexpr double kLargestZero = 1e-12;
/// If two values differ by less than this part of their magnitude, the difference is only rounding.
inline constexpr double kRounding = 5e-14;

/// Returns the range of the data, widened if it is too narrow for useful labels. If the data vary
/// only by rounding, each end moves outwards by a tenth of the value, or by 1 if the value is 0. If
/// all integers are equal, each end moves outwards by 1. `low` must not be above `high`, and both
/// must be finite.
template <AxisNumber Number>
[[nodiscard]] AxisSpan<Number> WidenedSpan(Number low, Number high);

/// Like WidenedSpan(), but each end is moved outwards to the nearest tick, or to the limit of the
/// number type if there is no tick further out.
template <AxisNumber Number>
[[nodiscard]] AxisSpan<Number> FittedSpan(Number low, Number high, int most);

/// Returns the ticks of an axis: about `most` ticks, but at least one. An axis without a span has
/// no ticks. Ticks are multiples of a step, which is 1, 2 or 5 times a power of ten. Each label can
/// be parsed back to the exact value of its tick, so all labels are different. All labels have as
/// many digits as the step needs, and an exponent if that makes them shorter.
template <AxisNumber Number>
[[nodiscard]] std::vector<AxisTick<Number>> TicksOf(const AxisSpan<Number>& span, int most);

/// Returns the position of a value on an axis with a span: 0 at or below the low end, 1 at or above
/// the high end. Returns not-a-number if the value is not a number.
template <AxisNumber Number>
[[nodiscard]] double PartOf(const AxisSpan<Number>& span, Number value);

}  // namespace tendon
