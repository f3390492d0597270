#pragma once

#include <vector>

namespace tendon::gui {

/// From the lower to the upper end of an axis.
struct AxisRange {
  double low = 0;
  double high = 1;

  [[nodiscard]] double span() const { return high - low; }
  [[nodiscard]] bool contains(const AxisRange& other) const {
    return low <= other.low && other.high <= high;
  }
  bool operator==(const AxisRange&) const = default;
};

/// How values are spread over an axis.
enum class ValueScale { kLinear, kLogarithmic };

/// Whole ones differ by 1 at least, and so do the labels of their axis.
enum class NumberKind { kReal, kWhole };

/// Where a value stands on an axis, whose range is one of such places: itself, or its decimal
/// logarithm; minus infinity for a value that has none, because it is 0 or less.
[[nodiscard]] double PlaceOf(double value, ValueScale scale);

/// The largest distance from 0 of values from base + low to base + high.
[[nodiscard]] double SizeOf(const AxisRange& data, double base);

/// 1, 2 or 5 times a power of ten, so that at most `most` steps fit into `span`.
[[nodiscard]] double NiceStep(double span, int most);
/// The same in seconds, and in minutes and hours beyond 30 s.
[[nodiscard]] double NiceTimeStep(double span_s, int most);

/// Whether values from base + low to base + high differ by no more than what sums of doubles leave
/// behind. Those are not magnified; real ones near 0 are at rest there.
[[nodiscard]] bool IsFlat(const AxisRange& data, double base, NumberKind numbers);

/// An axis for `data`, with a little air and round ends. `current` is kept while the data has its
/// air there and fills half of it, so that a live axis rests. Data that IsFlat() gets room of a
/// tenth of its size on either side. All are distances from `base`, finite and not huge.
[[nodiscard]] AxisRange FittedRange(const AxisRange& current, const AxisRange& data,
                                    NumberKind numbers = NumberKind::kReal, double base = 0);
/// The same of logarithms.
[[nodiscard]] AxisRange FittedDecades(const AxisRange& current, const AxisRange& data);
/// From one of so many states to another: `data` with half a state's room.
[[nodiscard]] AxisRange FittedStates(const AxisRange& data);

/// Whether an axis of this range can be drawn and written: both ends finite, not huge, and so far
/// apart that doubles between them differ.
[[nodiscard]] bool IsShowable(const AxisRange& range);

/// The multiples of `step` within `range`, as far as doubles tell them apart.
[[nodiscard]] std::vector<double> TicksOf(const AxisRange& range, double step);

/// How many digits behind the point tell multiples of `step` apart; at most 12.
[[nodiscard]] int DecimalsOf(double step);

}  // namespace tendon::gui
