#pragma once

#include <gcm_gui/plot/legend/legend.h>
#include <gcm_gui/plot/series/curve_set.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace tendon::gui {

/// A part of time, both ends in it, in ns.
struct TimeSpan {
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;
};

/// A number of a curve as people read it: the name of a state, an integer with all its digits, a
/// real with two digits more than its axis has.
[[nodiscard]] QString NumberOf(const ExactNumber& number, const Curve& curve,
                               const CurveSet& curves);

/// What a legend says of the curves: their values at `at_ns`, or their present ones, and the
/// statistics of a part of time where they are asked for. O(curves), and O(samples) of that part.
[[nodiscard]] std::vector<LegendEntry> LegendEntriesOf(const CurveSet& curves,
                                                       std::optional<std::int64_t> at_ns,
                                                       std::optional<TimeSpan> statistics);

}  // namespace tendon::gui
