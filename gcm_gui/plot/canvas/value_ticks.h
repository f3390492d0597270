#pragma once

#include <gcm_gui/plot/series/axis_range.h>
#include <gcm_gui/plot/series/curve_set.h>

#include <QString>
#include <vector>

namespace tendon::gui {

/// The positions and texts of the labels of a value axis. All texts differ.
struct ValueTicks {
  std::vector<double> places;  ///< in the units of the axis' range
  std::vector<QString> texts;  ///< of each
  double step = 1;             ///< the distance between two labels of a linear axis

  bool operator==(const ValueTicks&) const = default;
};

/// About `most` labels at most. On a logarithmic axis: at powers of ten; if there is room, also at
/// 2 and 5 times these; at round values if it shows less than a decade.
[[nodiscard]] ValueTicks TicksOf(const AxisRange& range, ValueScale scale, int most);
/// The same for an axis with its frame: the names of values if they have names, otherwise the
/// distance from the axis' base.
[[nodiscard]] ValueTicks TicksOf(const UnitAxis& axis, ValueScale scale, int most);

/// Returns 0 for a tick that is nearly 0, such as -0 or 1e-17; otherwise `value`.
[[nodiscard]] double Cleaned(double value, double step);

/// Formats `value`, a multiple of `step`, with as many digits as its neighbours require. A long
/// number gets an exponent, relative to 10^`exponent`.
[[nodiscard]] QString StepText(double value, double step, int exponent = 0);

/// The text above the labels: the unit, and the base to add to each label: "+9e9 ns".
[[nodiscard]] QString HeadOf(const UnitAxis& axis);

}  // namespace tendon::gui
