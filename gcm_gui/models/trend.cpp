#include <gcm_gui/models/trend.h>
#include <tendon/payload/numeric_axis.h>

#include <limits>
#include <vector>

namespace tendon::gui {

Trend TrendOf(const Schema& channel, const QList<std::optional<NumericValue>>& values) {
  constexpr double kNoPlace = std::numeric_limits<double>::quiet_NaN();
  std::vector<NumericValue> known;
  for (const auto& value : values) {
    if (value) known.push_back(*value);
  }
  const NumericAxis axis = NumericAxis::Tight(channel, known);
  Trend trend{.parts = {}, .is_stepped = IsStepped(channel)};
  trend.parts.reserve(values.size());
  for (const auto& value : values) {
    trend.parts.append(value ? axis.PartOf(*value).value_or(kNoPlace) : kNoPlace);
  }
  return trend;
}

}  // namespace tendon::gui
