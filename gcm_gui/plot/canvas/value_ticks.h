#pragma once

#include <gcm_gui/plot/series/axis_range.h>
#include <gcm_gui/plot/series/curve_set.h>

#include <QString>
#include <vector>

namespace tendon::gui {

/// The positions and texts of the labels of a value axis. No two texts are the same.
struct ValueTicks {
  std::vector<double> places;  ///< in the unit of the axis' range
  std::vector<QString> texts;  ///< one for each place
  double step = 1;             ///< the distance between two labels of a linear axis

  bool operator==(const ValueTicks&) const = default;
};

/// Returns about `most` labels or fewer. On a logarithmic axis, the labels are at powers of ten
/// and, if there is room, also at 2 and 5 times these powers. If the axis shows less than a decade,
/// the labels are at round values.
[[nodiscard]] ValueTicks TicksOf(const AxisRange& range, ValueScale scale, int most);
/// Returns the labels of an axis in its frame: the names of the values if they have names,
/// otherwise the distance from the base of the axis.
[[nodiscard]] ValueTicks TicksOf(const UnitAxis& axis, ValueScale scale, int most);

/// Returns 0 for a tick that is nearly 0, such as -0 or 1e-17; otherwise `value`.
[[nodiscard]] double Cleaned(double value, double step);

/// Formats `value`, a multiple of `step`, with enough digits to distinguish it from its neighbours.
/// A long number gets an exponent, relative to 10^`exponent`.
[[nodiscard]] QString StepText(double value, double step, int exponent = 0);

/// Returns the text above the labels: the unit, and the base to add to each label, such as "+9e9
/// ns".
[[nodiscard]] QString HeadOf(const UnitAxis& axis);

}  // namespace tendon::gui
