#pragma once

#include <gcm_gui/plot/series/axis_range.h>
#include <gcm_gui/plot/series/curve_set.h>

#include <QString>
#include <vector>

namespace tendon::gui {

/// Where an axis of values has its labels, and what they say; no two say the same.
struct ValueTicks {
  std::vector<double> places;  ///< in the axis' range, which is one of places
  std::vector<QString> texts;  ///< of each
  double step = 1;             ///< between two labels of a linear axis

  bool operator==(const ValueTicks&) const = default;
};

/// At most about `most` of them. On a logarithmic axis powers of ten; 2 and 5 times those where
/// there is room; and round values where it shows less than a decade.
[[nodiscard]] ValueTicks TicksOf(const AxisRange& range, ValueScale scale, int most);
/// The same of an axis with its frame: names where its values have them, and else numbers that are
/// distances from its base.
[[nodiscard]] ValueTicks TicksOf(const UnitAxis& axis, ValueScale scale, int most);

/// A tick at 0 may come as -0 or as 1e-17: 0 for those, else `value`.
[[nodiscard]] double Cleaned(double value, double step);

/// `value`, a multiple of `step`, with the digits that tell it from its neighbours, and an exponent
/// where it would be long, which counts from 10^`exponent`.
[[nodiscard]] QString StepText(double value, double step, int exponent = 0);

/// What stands above the labels: the unit, and what is added to each label: "+9e9 ns".
[[nodiscard]] QString HeadOf(const UnitAxis& axis);

}  // namespace tendon::gui
