#include <gcm_gui/models/sparkline.h>

#include <tendon/payload/numeric_axis.h>

#include <limits>
#include <vector>

namespace tendon::gui {

Sparkline SparklineOf(const Schema& field, const QList<std::optional<NumericValue>>& values) {
  constexpr double kNoPlace = std::numeric_limits<double>::quiet_NaN();
  std::vector<NumericValue> known;
  for (const auto& value : values) {
    if (value) known.push_back(*value);
  }
  const NumericAxis axis = NumericAxis::Tight(field, known);
  Sparkline trend{.parts = {}, .is_stepped = IsStepped(field)};
  trend.parts.reserve(values.size());
  for (const auto& value : values) {
    trend.parts.append(value ? axis.PartOf(*value).value_or(kNoPlace) : kNoPlace);
  }
  return trend;
}

}  // namespace tendon::gui
