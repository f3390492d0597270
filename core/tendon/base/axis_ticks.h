#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

/// Axes of numbers for a window, a terminal or a page: the range that an axis shows, the positions
/// of its labels, and their texts. All functions are pure, work for every finite double and every
/// 64-bit integer, and give finite results.
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

/// Values below this size are rounding errors of 0.
inline constexpr double kLargestZero = 1e-12;
/// Two values that differ by less than this part of their size are equal, apart from rounding.
inline constexpr double kRounding = 5e-14;

/// The range of the data, widened if it is too narrow for useful labels. Data that vary only by
/// rounding are widened by a tenth of their size on each side, or by 1 around 0; equal integers are
/// widened by 1. `low` must not be above `high`, and both must be finite.
template <AxisNumber Number>
[[nodiscard]] AxisSpan<Number> WidenedSpan(Number low, Number high);

/// Like WidenedSpan(), but each end is moved outwards to the nearest tick, or to the limit of the
/// number type if there is no tick further out.
template <AxisNumber Number>
[[nodiscard]] AxisSpan<Number> FittedSpan(Number low, Number high, int most);

/// The ticks of an axis: multiples of a step, which is 1, 2 or 5 times a power of ten. There are
/// about `most` ticks, and at least one; but none if the axis has no span. Each label can be parsed
/// back to the exact value of its tick, so all labels are different. All labels have as many digits
/// as the step needs, and an exponent if that is shorter.
template <AxisNumber Number>
[[nodiscard]] std::vector<AxisTick<Number>> TicksOf(const AxisSpan<Number>& span, int most);

/// The position of a value on an axis with a span: 0 at or below the low end, 1 at or above the
/// high end. Not-a-number stays not-a-number.
template <AxisNumber Number>
[[nodiscard]] double PartOf(const AxisSpan<Number>& span, Number value);

}  // namespace tendon
