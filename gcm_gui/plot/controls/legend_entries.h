#pragma once

#include <gcm_gui/plot/controls/legend.h>
#include <gcm_gui/plot/series/curve_set.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace tendon::gui {

/// A time span in ns, both ends included.
struct TimeSpan {
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;
};

/// Formats a number of a curve: as the name of a state, as an integer with all digits, or as a real
/// number with two digits more than the axis.
[[nodiscard]] QString NumberOf(const ExactNumber& number, const Curve& curve,
                               const CurveSet& curves);

/// Returns the rows of the legend. The rows contain the values at `at_ns`; without `at_ns`, the
/// present values. If a time span is given, the rows also contain its statistics. O(curves) +
/// O(samples in the span).
[[nodiscard]] std::vector<LegendEntry> LegendEntriesOf(const CurveSet& curves,
                                                       std::optional<std::int64_t> at_ns,
                                                       std::optional<TimeSpan> statistics);

}  // namespace tendon::gui
