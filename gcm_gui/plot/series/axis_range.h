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

/// Where a value stands on an axis, whose range is one of such places: itself, or its decimal
/// logarithm; minus infinity for a value that has none, because it is 0 or less.
[[nodiscard]] double PlaceOf(double value, ValueScale scale);

/// 1, 2 or 5 times a power of ten, so that at most `most` steps fit into `span`.
[[nodiscard]] double NiceStep(double span, int most);
/// The same in seconds, and in minutes and hours beyond 30 s.
[[nodiscard]] double NiceTimeStep(double span_s, int most);

/// An axis for `data`, with a little air and round ends. `current` is kept while the data has its
/// air there and fills half of it, so that a live axis rests.
[[nodiscard]] AxisRange FittedRange(const AxisRange& current, const AxisRange& data);

/// The multiples of `step` within `range`.
[[nodiscard]] std::vector<double> TicksOf(const AxisRange& range, double step);

/// How many digits behind the point tell multiples of `step` apart.
[[nodiscard]] int DecimalsOf(double step);

}  // namespace tendon::gui
