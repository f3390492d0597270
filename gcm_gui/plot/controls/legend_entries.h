#pragma once

#include <gcm_gui/plot/controls/legend.h>
#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/series/time_window.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace tendon::gui {

/// Formats a number of a curve: as the name of a state, as an integer with all digits, or as a real
/// number with two digits more than the axis.
[[nodiscard]] QString NumberOf(const ExactNumber& number, const Curve& curve,
                               const CurveSet& curves);

/// Returns the rows of the legend. The rows contain the values at `at_ns`; without `at_ns`, they
/// contain the present values of live curves, and the values of recorded curves at the end of the
/// visible time. The rows may also contain statistics of the visible time. O(curves) + O(samples in
/// the visible time).
[[nodiscard]] std::vector<LegendEntry> LegendEntriesOf(const CurveSet& curves,
                                                       std::optional<std::int64_t> at_ns,
                                                       const TimeSpan& seen, bool statistics);

}  // namespace tendon::gui
