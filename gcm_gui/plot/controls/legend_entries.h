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

/// A curve's number as text: the name of a state, an integer with all digits, a real with two
/// digits more than its axis.
[[nodiscard]] QString NumberOf(const ExactNumber& number, const Curve& curve,
                               const CurveSet& curves);

/// The legend of the curves: their values at `at_ns`, or their present ones; and the statistics of
/// a time span, if requested. O(curves), and O(samples) of that span.
[[nodiscard]] std::vector<LegendEntry> LegendEntriesOf(const CurveSet& curves,
                                                       std::optional<std::int64_t> at_ns,
                                                       std::optional<TimeSpan> statistics);

}  // namespace tendon::gui
