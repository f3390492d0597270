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

/// The kind of values on an axis. Two different whole numbers differ by at least 1, so the labels
/// of their axis also differ by at least 1.
enum class NumberKind { kReal, kWhole };

/// Returns the place of a value on an axis: the value itself, or its decimal logarithm. On a
/// logarithmic axis, a value of 0 or less is at minus infinity.
[[nodiscard]] double PlaceOf(double value, ValueScale scale);

/// Returns the largest absolute value in the range from base + low to base + high.
[[nodiscard]] double SizeOf(const AxisRange& data, double base);

/// Returns 1, 2 or 5 times a power of ten, such that at most `most` steps fit into `span`.
[[nodiscard]] double NiceStep(double span, int most);
/// Does the same as NiceStep() for a step in seconds. Long steps are a round number of minutes or
/// hours.
[[nodiscard]] double NiceTimeStep(double span_s, int most);

/// Returns true if the values from base + low to base + high differ only by rounding errors. An
/// axis must not magnify rounding errors. Real values very close to 0 count as equal to 0.
[[nodiscard]] bool IsFlat(const AxisRange& data, double base, NumberKind numbers);

/// Returns the range of an axis for `data`, with a margin and round ends. Returns `current` if the
/// data with the margin fits into it and fills half of it, so that a live axis does not move all
/// the time. The margin of flat data (see IsFlat()) is a tenth of its absolute value. All arguments
/// are distances from `base`; they are finite and not huge.
[[nodiscard]] AxisRange FittedRange(const AxisRange& current, const AxisRange& data,
                                    NumberKind numbers = NumberKind::kReal, double base = 0);
/// Does the same as FittedRange() for logarithms of values.
[[nodiscard]] AxisRange FittedDecades(const AxisRange& current, const AxisRange& data);
/// Returns the range of an axis for states, given by their numbers: `data` with a margin of at
/// least 0.3.
[[nodiscard]] AxisRange FittedStates(const AxisRange& data);

/// Returns true if an axis of this range can be drawn and labelled: both ends are finite, not huge,
/// and so far apart that there are enough doubles between them.
[[nodiscard]] bool IsShowable(const AxisRange& range);

/// Returns the multiples of `step` within `range`; none if doubles cannot distinguish them.
[[nodiscard]] std::vector<double> TicksOf(const AxisRange& range, double step);

/// Returns the number of decimals that are needed to distinguish multiples of `step`; at most 12.
[[nodiscard]] int DecimalsOf(double step);

}  // namespace tendon::gui
