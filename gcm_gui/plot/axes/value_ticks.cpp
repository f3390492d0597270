#include <gcm_gui/plot/axes/value_ticks.h>

#include <algorithm>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr double kFewDecades = 2.5;  // where 2 and 5 have room between powers of ten
constexpr double kTolerance = 1e-9;

// Of less than a decade: the values themselves are evenly spaced.
std::vector<double> WithinADecade(const AxisRange& range, int most) {
  const AxisRange values{.low = std::pow(10, range.low), .high = std::pow(10, range.high)};
  std::vector<double> places = TicksOf(values, NiceStep(values.span(), most));
  std::erase_if(places, [](double value) { return value <= 0; });
  for (double& place : places) place = std::log10(place);
  return places;
}

}  // namespace

ValueTicks TicksOf(const AxisRange& range, ValueScale scale, int most) {
  if (scale == ValueScale::kLinear) {
    const double step = NiceStep(range.span(), most);
    return {.places = TicksOf(range, step), .step = step};
  }
  if (range.span() < 1) return {.places = WithinADecade(range, most)};
  if (range.span() > kFewDecades) {
    return {.places = TicksOf(range, std::max(1.0, NiceStep(range.span(), most)))};
  }
  ValueTicks ticks;
  for (double decade = std::floor(range.low); decade <= range.high; ++decade) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double place = decade + std::log10(factor);
      const bool is_seen = place >= range.low - kTolerance && place <= range.high + kTolerance;
      if (is_seen) ticks.places.push_back(place);
    }
  }
  return ticks;
}

QString LogarithmicText(double place) {
  constexpr int kDigits = 6;
  return QString::number(std::pow(10, place), 'g', kDigits);
}

}  // namespace tendon::gui
