#include <gcm_gui/plot/series/axis_range.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tendon::gui {
namespace {

constexpr int kSteps = 6;      // the maximum number of steps of a fitted axis
constexpr double kAir = 0.06;  // margin above and below, as a fraction of the data's span
constexpr double kEnoughFill = 0.5;
constexpr double kTolerance = 1e-9;

// These limits are the same as in tendon/base/axis_ticks.h, which this library does not use. A test
// compares them.
constexpr double kAtRest = 1e-12;    // above the rounding errors of sums of numbers near 1
constexpr double kRounding = 5e-14;  // relative; smaller than a change of the 13th digit
constexpr double kMinSpan = 1e-12;   // smallest span of an axis, relative to its values
constexpr double kFlatDecades = 1e-6;
constexpr AxisRange kDecades{.low = -324, .high = 309};  // the range of doubles

constexpr double kMinStep = 1e-300;
constexpr double kMaxPlace = 1e290;
// 2^49: leaves some digits of a double for fractions of a step.
constexpr double kExactSteps = 562949953421312;
constexpr std::size_t kMaxTicks = 1000;

AxisRange WithAir(const AxisRange& data) {
  const double air = data.span() * kAir;
  return {.low = data.low - air, .high = data.high + air};
}

// Returns `data` with a margin. A single value gets a span relative to the value.
AxisRange Widened(const AxisRange& data, NumberKind numbers, double base) {
  if (!IsFlat(data, base, numbers)) return WithAir(data);
  const double size = SizeOf(data, base);
  const bool is_small = numbers == NumberKind::kWhole ? size < 1 : size < kAtRest;
  const double least = numbers == NumberKind::kWhole ? 1 : 0;
  const double half = is_small ? 1 : std::max(size * 0.1, least);
  const double middle = is_small ? -base : (data.low + data.high) / 2;
  return {.low = middle - half, .high = middle + half};
}

AxisRange Rested(const AxisRange& current, const AxisRange& wide, const AxisRange& fitted) {
  const bool rests = current.contains(wide) && fitted.span() >= kEnoughFill * current.span();
  return rests ? current : fitted;
}

AxisRange WithRoundEnds(const AxisRange& wide) {
  const double half_step = NiceStep(wide.span(), kSteps) / 2;
  return {.low = std::floor(wide.low / half_step) * half_step,
          .high = std::ceil(wide.high / half_step) * half_step};
}

}  // namespace

double PlaceOf(double value, ValueScale scale) {
  if (scale == ValueScale::kLinear) return value;
  return value > 0 ? std::log10(value) : -std::numeric_limits<double>::infinity();
}

double SizeOf(const AxisRange& data, double base) {
  return std::max(std::abs(base + data.low), std::abs(base + data.high));
}

double NiceStep(double span, int most) {
  const double least = std::clamp(span / most, kMinStep, kMaxPlace);
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

bool IsFlat(const AxisRange& data, double base, NumberKind numbers) {
  if (numbers == NumberKind::kWhole) return data.span() < 1;
  const double size = SizeOf(data, base);
  return size < kAtRest || data.span() < size * kRounding;
}

AxisRange FittedRange(const AxisRange& current, const AxisRange& data, NumberKind numbers,
                      double base) {
  const AxisRange wide = Widened(data, numbers, base);
  return Rested(current, wide, WithRoundEnds(wide));
}

AxisRange FittedDecades(const AxisRange& current, const AxisRange& data) {
  constexpr double kHalf = 0.5;
  const AxisRange wide = data.span() >= kFlatDecades
                             ? WithAir(data)
                             : AxisRange{.low = data.low - kHalf, .high = data.high + kHalf};
  const AxisRange fitted = WithRoundEnds(wide);
  return Rested(
      current, wide,
      {.low = std::max(fitted.low, kDecades.low), .high = std::min(fitted.high, kDecades.high)});
}

AxisRange FittedStates(const AxisRange& data) {
  constexpr double kRoom = 0.3;
  const double air = std::max(kRoom, data.span() * kAir);
  return {.low = data.low - air, .high = data.high + air};
}

bool IsShowable(const AxisRange& range) {
  const double size = SizeOf(range, 0);
  return size <= kMaxPlace && range.span() >= kMinStep && range.span() >= size * kMinSpan;
}

std::vector<double> TicksOf(const AxisRange& range, double step) {
  const double first = std::ceil(range.low / step - kTolerance);
  const double last = std::floor(range.high / step + kTolerance);
  const bool are_apart = std::abs(first) < kExactSteps && std::abs(last) < kExactSteps;
  if (!are_apart || last < first) return {};
  const double count = std::min<double>(last - first + 1, kMaxTicks);
  std::vector<double> ticks(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < ticks.size(); ++i) ticks[i] = (first + static_cast<double>(i)) * step;
  return ticks;
}

int DecimalsOf(double step) {
  constexpr double kMax = 12;
  if (!(step > 0)) return 0;
  return static_cast<int>(std::clamp(std::ceil(-std::log10(step) - kTolerance), 0.0, kMax));
}

}  // namespace tendon::gui
