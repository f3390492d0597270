#pragma once

#include <vector>

namespace tendon::gui {

/// The range of an axis.
struct AxisRange {
  double low = 0;
  double high = 1;

  [[nodiscard]] double span() const { return high - low; }
  [[nodiscard]] bool contains(const AxisRange& other) const {
    return low <= other.low && other.high <= high;
  }
  bool operator==(const AxisRange&) const = default;
};

/// The scale of a value axis.
enum class ValueScale { kLinear, kLogarithmic };

/// The kind of values on an axis. Whole numbers, and the labels of their axis, differ by at least
/// 1.
enum class NumberKind { kReal, kWhole };

/// The place of a value on an axis: the value itself, or its decimal logarithm. Minus infinity for
/// a value of 0 or less on a logarithmic axis.
[[nodiscard]] double PlaceOf(double value, ValueScale scale);

/// The largest absolute value from base + low to base + high.
[[nodiscard]] double SizeOf(const AxisRange& data, double base);

/// 1, 2 or 5 times a power of ten, such that at most `most` steps fit into `span`.
[[nodiscard]] double NiceStep(double span, int most);
/// The same in seconds; beyond 30 s round numbers of minutes and hours.
[[nodiscard]] double NiceTimeStep(double span_s, int most);

/// True if the values from base + low to base + high differ only by rounding errors, which are not
/// magnified. Real values very close to 0 count as equal to 0.
[[nodiscard]] bool IsFlat(const AxisRange& data, double base, NumberKind numbers);

/// An axis for `data`, with a margin and round ends. Keeps `current` while the data fits into it
/// with the margin and fills half of it, so that a live axis does not move all the time. The margin
/// of flat data (IsFlat()) is a tenth of its size. All are distances from `base`, finite and not
/// huge.
[[nodiscard]] AxisRange FittedRange(const AxisRange& current, const AxisRange& data,
                                    NumberKind numbers = NumberKind::kReal, double base = 0);
/// The same for logarithms.
[[nodiscard]] AxisRange FittedDecades(const AxisRange& current, const AxisRange& data);
/// An axis for states by number: `data` with a margin of 0.3 states or more.
[[nodiscard]] AxisRange FittedStates(const AxisRange& data);

/// True if an axis of this range can be drawn and labelled: both ends finite, not huge, and far
/// enough apart to distinguish doubles between them.
[[nodiscard]] bool IsShowable(const AxisRange& range);

/// The multiples of `step` within `range`; none if doubles cannot distinguish them.
[[nodiscard]] std::vector<double> TicksOf(const AxisRange& range, double step);

/// The number of decimals that distinguish multiples of `step`; at most 12.
[[nodiscard]] int DecimalsOf(double step);

}  // namespace tendon::gui
