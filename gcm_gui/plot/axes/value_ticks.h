#pragma once

#include <gcm_gui/plot/series/axis_range.h>

#include <QString>
#include <vector>

namespace tendon::gui {

/// Where an axis of values has its labels: places in `range`, which is one of places (see PlaceOf).
struct ValueTicks {
  std::vector<double> places;
  double step = 1;  ///< between two labels of a linear axis
};

/// At most about `most` of them. On a logarithmic axis powers of ten; 2 and 5 times those where
/// there is room; and round values where it shows less than a decade.
[[nodiscard]] ValueTicks TicksOf(const AxisRange& range, ValueScale scale, int most);

/// What the label at a place of a logarithmic axis says: "0.001", "50", "1e+06".
[[nodiscard]] QString LogarithmicText(double place);

}  // namespace tendon::gui
