#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

/// Axes of numbers for a window, a terminal or a page: which part of the numbers one shows, where
/// its labels are, and what they say. Everything here is a pure function, works for every finite
/// double and every 64-bit integer, and gives finite results.
namespace tendon {

/// From the lower to the upper end of an axis.
template <typename Number>
struct AxisSpan {
  Number low{};
  Number high{};

  bool operator==(const AxisSpan&) const = default;
};

/// A place on an axis, and what its label says.
template <typename Number>
struct AxisTick {
  Number value{};
  std::string label;

  bool operator==(const AxisTick&) const = default;
};

template <typename Number>
concept AxisNumber = std::same_as<Number, double> || std::same_as<Number, std::int64_t> ||
    std::same_as<Number, std::uint64_t>;

/// Values below this size are what rounding leaves of 0.
inline constexpr double kNothing = 1e-12;
/// Values that differ by less than this part of their size differ by what rounding leaves.
inline constexpr double kRounding = 5e-14;

/// The data's ends, so far apart that the labels in between mean something. Values at rest, which
/// differ by no more than rounding, get a tenth of their size up and down, or 1 around 0; integers
/// that are all the same get 1. `low` is not above `high`, and both are finite.
template <AxisNumber Number>
[[nodiscard]] AxisSpan<Number> WidenedSpan(Number low, Number high);

/// The same, with its ends moved outwards to the nearest ticks; where there is none, to the end of
/// all numbers.
template <AxisNumber Number>
[[nodiscard]] AxisSpan<Number> FittedSpan(Number low, Number high, int most);

/// About `most` multiples, and at least one, of one step, which is 1, 2 or 5 times a power of ten.
/// Each label reads back as its tick, so that no two are alike; all have as many digits as the step
/// needs, with an exponent where that is shorter. Empty where the axis has no span.
template <AxisNumber Number>
[[nodiscard]] std::vector<AxisTick<Number>> TicksOf(const AxisSpan<Number>& span, int most);

/// Where a value stands on an axis that has a span: 0 at its low end and below, 1 at its high end
/// and above. Not-a-number stays that.
template <AxisNumber Number>
[[nodiscard]] double PartOf(const AxisSpan<Number>& span, Number value);

}  // namespace tendon
