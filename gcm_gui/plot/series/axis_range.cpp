#include <gcm_gui/plot/series/axis_range.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tendon::gui {
namespace {

constexpr int kSteps = 6;      // of a fitted axis, at most
constexpr double kAir = 0.06;  // of the data's span, above and below
constexpr double kEnoughFill = 0.5;
constexpr double kTolerance = 1e-9;

// One value has no span: give it one of its own size.
AxisRange Widened(const AxisRange& data) {
  const double size = std::max(std::abs(data.low), std::abs(data.high));
  const double least = size == 0 ? 1 : size * 1e-6;
  if (data.span() >= least) {
    const double air = data.span() * kAir;
    return {.low = data.low - air, .high = data.high + air};
  }
  const double half = size == 0 ? 1 : size * 0.1;
  const double middle = (data.low + data.high) / 2;
  return {.low = middle - half, .high = middle + half};
}

}  // namespace

double PlaceOf(double value, ValueScale scale) {
  if (scale == ValueScale::kLinear) return value;
  return value > 0 ? std::log10(value) : -std::numeric_limits<double>::infinity();
}

double NiceStep(double span, int most) {
  const double least = span / most;
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1 - kTolerance)) return factor * power;
  }
  return 10 * power;
}

double NiceTimeStep(double span_s, int most) {
  constexpr std::array kLongSteps{15.0,  30.0,   60.0,   120.0,  300.0,   600.0,
                                  900.0, 1800.0, 3600.0, 7200.0, 14400.0, 21600.0};
  const double step = NiceStep(span_s, most);
  if (step <= 10) return step;
  const auto* const longer =
      std::lower_bound(kLongSteps.begin(), kLongSteps.end(), span_s / most * (1 - kTolerance));
  return longer == kLongSteps.end() ? 3600 * NiceStep(span_s / 3600, most) : *longer;
}

AxisRange FittedRange(const AxisRange& current, const AxisRange& data) {
  const AxisRange wide = Widened(data);
  const double half_step = NiceStep(wide.span(), kSteps) / 2;
  const AxisRange fitted{.low = std::floor(wide.low / half_step) * half_step,
                         .high = std::ceil(wide.high / half_step) * half_step};
  const bool rests = current.contains(wide) && fitted.span() >= kEnoughFill * current.span();
  return rests ? current : fitted;
}

std::vector<double> TicksOf(const AxisRange& range, double step) {
  const double first = std::ceil(range.low / step - kTolerance);
  const double last = std::floor(range.high / step + kTolerance);
  std::vector<double> ticks(last < first ? 0 : static_cast<std::size_t>(last - first) + 1);
  for (std::size_t i = 0; i < ticks.size(); ++i) ticks[i] = (first + static_cast<double>(i)) * step;
  return ticks;
}

int DecimalsOf(double step) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - kTolerance)), 0, 12);
}

}  // namespace tendon::gui
