#include <gcm_gui/plot/canvas/value_ticks.h>

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <set>

namespace tendon::gui {
namespace {

// With fewer decades, labels at 2 and 5 fit between the powers of ten.
constexpr double kFewDecades = 2.5;
constexpr double kTickTolerance = 1e-9;
constexpr double kLargestPlain = 1e6;  // larger numbers, and steps below kTiny, get an exponent
constexpr double kTiny = 1e-5;
constexpr int kPlainDecades = 5;  // decades above or below 1 without an exponent
constexpr std::size_t kMaxNames = 14;

int DecadeOf(double value) {
  return static_cast<int>(std::floor(std::log10(value) + kTickTolerance));
}

// Formats a number with an exponent as QString does: "1.5e+308".
QString WithExponent(QString mantissa, int exponent) {
  if (mantissa.contains('.')) {
    while (mantissa.endsWith('0')) mantissa.chop(1);
    if (mantissa.endsWith('.')) mantissa.chop(1);
  }
  return mantissa + (exponent < 0 ? "e-" : "e+") +
         QString::number(std::abs(exponent)).rightJustified(2, '0');
}

// Formats 10^decade times `value`, which is a multiple of `step`.
QString DecadeText(double value, double step, int decade) {
  if (std::abs(decade) > kPlainDecades) return StepText(value, step, decade);
  const double power = std::pow(10, decade);
  return StepText(value * power, step * power);
}

void Add(ValueTicks& ticks, double place, const QString& text) {
  ticks.places.push_back(place);
  ticks.texts.push_back(text);
}

// Returns the labels for less than a decade. Round values are then evenly spaced. Calculates with
// numbers divided by a power of ten: near the limits of doubles, the values themselves may become
// infinite.
ValueTicks WithinADecade(const AxisRange& range, int most) {
  ValueTicks ticks;
  const double decade = std::floor(range.low);
  const AxisRange values{.low = std::pow(10, range.low - decade),
                         .high = std::pow(10, range.high - decade)};
  ticks.step = NiceStep(values.span(), most);
  for (const double value : TicksOf(values, ticks.step)) {
    if (value <= 0) continue;
    Add(ticks, decade + std::log10(value), DecadeText(value, ticks.step, static_cast<int>(decade)));
  }
  return ticks;
}

ValueTicks LogarithmicTicks(const AxisRange& wanted, int most) {
  constexpr AxisRange kDoubles{.low = -324, .high = 309};
  const AxisRange range{.low = std::max(wanted.low, kDoubles.low),
                        .high = std::min(wanted.high, kDoubles.high)};
  if (range.low >= range.high) return {};
  if (range.span() < 1) return WithinADecade(range, most);
  ValueTicks ticks;
  if (range.span() > kFewDecades) {
    ticks.step = std::max(1.0, NiceStep(range.span(), most));
    for (const double place : TicksOf(range, ticks.step)) {
      Add(ticks, place, DecadeText(1, 1, static_cast<int>(std::lround(place))));
    }
    return ticks;
  }
  for (double decade = std::floor(range.low); decade <= range.high; ++decade) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double place = decade + std::log10(factor);
      const bool is_seen =
          place >= range.low - kTickTolerance && place <= range.high + kTickTolerance;
      if (is_seen) Add(ticks, place, DecadeText(factor, 1, static_cast<int>(decade)));
    }
  }
  return ticks;
}

// Returns as many names as fit. Long names are shortened only if the shortened names still differ.
ValueTicks NamedTicks(const UnitAxis& axis) {
  constexpr qsizetype kLongestLabel = 20;  // characters
  ValueTicks ticks;
  std::vector<const ValueNames::Entry*> seen;
  for (const ValueNames::Entry& one : axis.names->all) {
    const auto place = static_cast<double>(one.value);
    if (place >= axis.range.low && place <= axis.range.high) seen.push_back(&one);
  }
  const std::size_t every = (seen.size() + kMaxNames - 1) / kMaxNames;
  std::set<QString> shorts;
  for (std::size_t i = 0; i < seen.size(); i += every) {
    const QString& name = seen[i]->name;
    const QString brief = name.size() <= kLongestLabel
                              ? name
                              : name.left(kLongestLabel / 2) + QStringLiteral("…") +
                                    name.right(kLongestLabel / 2 - 1);
    const bool is_new = shorts.insert(brief).second;
    Add(ticks, static_cast<double>(seen[i]->value), is_new ? brief : name);
  }
  return ticks;
}

ValueTicks LinearTicks(const AxisRange& range, double step, int exponent) {
  ValueTicks ticks{.places = TicksOf(range, step), .step = step};
  for (const double place : ticks.places) ticks.texts.push_back(StepText(place, step, exponent));
  return ticks;
}

}  // namespace

double Cleaned(double value, double step) { return std::abs(value) < step * 1e-6 ? 0 : value; }

QString StepText(double value, double step, int exponent) {
  constexpr int kMaxDigits = 17;
  const double shown = Cleaned(value, step);
  const bool is_plain = exponent == 0 && std::abs(value) < kLargestPlain && step > kTiny;
  if (is_plain) return QString::number(shown, 'f', DecimalsOf(step));
  if (shown == 0 || !std::isfinite(shown)) return QString::number(shown);
  const int digits = std::clamp(DecadeOf(std::abs(shown)) - DecadeOf(step) + 1, 1, kMaxDigits);
  if (exponent == 0) return QString::number(shown, 'g', digits);
  const QStringList parts = QString::number(shown, 'e', digits - 1).split('e');
  return WithExponent(parts.front(), parts.back().toInt() + exponent);
}

ValueTicks TicksOf(const AxisRange& range, ValueScale scale, int most) {
  if (scale == ValueScale::kLogarithmic) return LogarithmicTicks(range, most);
  return LinearTicks(range, NiceStep(range.span(), most), 0);
}

ValueTicks TicksOf(const UnitAxis& axis, ValueScale scale, int most) {
  if (scale == ValueScale::kLogarithmic) return LogarithmicTicks(axis.range, most);
  const bool is_whole = axis.numbers == NumberKind::kWhole;
  if (is_whole && axis.names != nullptr) return NamedTicks(axis);
  const double step = NiceStep(axis.range.span(), most);
  return LinearTicks(axis.range, is_whole ? std::max(step, 1.0) : step, axis.frame.exponent);
}

QString HeadOf(const UnitAxis& axis) {
  return QStringList{axis.frame.baseText(), axis.unit}.join(' ').trimmed();
}

}  // namespace tendon::gui
