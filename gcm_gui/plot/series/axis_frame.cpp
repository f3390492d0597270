#include <gcm_gui/plot/series/axis_frame.h>

#include <QLocale>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr double kHuge = 1e290;     // above this, distances may be infinite
constexpr double kFar = 2e4;        // distance from 0, in spans, above which labels become long
constexpr double kNear = kFar / 4;  // distance from 0, in spans, below which labels are short again
// 2^52: half of the integers that a double can distinguish.
constexpr double kExact = 4503599627370496;

// Returns a round number near the middle of the data. Labels relative to this number need at most
// one more digit. For integers, the number is not farther from 0 than the middle, because the range
// of the integer type may end there.
double RoundBase(double middle, double span, NumberKind numbers) {
  const double digits = std::ceil(std::log10(span)) + 1;
  const double power = std::pow(10, std::abs(digits));
  if (numbers == NumberKind::kWhole) {
    return digits >= 0 ? std::trunc(middle / power) * power : std::trunc(middle);
  }
  if (digits >= 0) return std::round(middle / power) * power;
  return std::round(middle * power) / power;
}

// Returns true if labels relative to this base need no additional digits. A live axis with only a
// few samples may have no round number near them.
bool IsRound(double base, double span) {
  const double steps = base / std::pow(10, std::ceil(std::log10(span)) - 1);
  const double tolerance = 1e-3 + std::abs(steps) * 1e-15;
  return std::abs(steps - std::round(steps)) <= tolerance;
}

// Formats a base. Shows all digits of an integer if they are readable. Other numbers are as short
// as possible.
QString BaseText(double base) {
  constexpr int kMaxZeros = 4;
  constexpr double kIntegers = 1e20;  // larger than any 64-bit integer
  if (base != std::floor(base) || std::abs(base) >= kIntegers) {
    return QString::number(base, 'g', QLocale::FloatingPointShortest);
  }
  const QString digits = QString::number(std::abs(base), 'f', 0);
  QString front = digits;
  while (front.endsWith('0')) front.chop(1);
  const QString sign = base < 0 ? QStringLiteral("-") : QString();
  if (digits.size() - front.size() <= kMaxZeros) return sign + digits;
  const QString exponent = 'e' + QString::number(digits.size() - 1);
  if (front.size() > 1) front.insert(1, '.');
  return sign + front + exponent;
}

}  // namespace

QString AxisFrame::baseText() const {
  if (base == 0) return {};
  return (base > 0 ? QStringLiteral("+") : QString()) + BaseText(base);
}

AxisRange Moved(const AxisRange& range, const AxisFrame& from, const AxisFrame& to) {
  if (from == to) return range;
  const double stretch = from.exponent == to.exponent  ? 1
                         : from.exponent > to.exponent ? 1 / AxisFrame::kOfExponent
                                                       : AxisFrame::kOfExponent;
  const double by = from.base - to.base;
  return {.low = range.low * stretch + by, .high = range.high * stretch + by};
}

AxisFrame FrameFor(const AxisFrame& current, const AxisRange& distances, NumberKind numbers) {
  const double size = SizeOf(distances, current.base);
  const double reach = SizeOf(distances, 0);
  if (size >= kHuge || reach >= kHuge) return {.exponent = AxisFrame::kExponent};
  const double span = distances.span();
  if (IsFlat(distances, current.base, numbers)) {
    // Far from the base, doubles cannot distinguish integers; near a base they can.
    if (numbers != NumberKind::kWhole || size < kExact) return {};
    return reach < kExact ? current : AxisFrame{.base = current.base + distances.low};
  }
  if (size < (current.base == 0 ? kFar : kNear) * span) return {};
  const bool serves =
      current.base != 0 && reach < kFar * span && reach < kExact && IsRound(current.base, span);
  if (serves && current.exponent == 0) return current;
  return {.base = RoundBase(current.base + (distances.low + distances.high) / 2, span, numbers)};
}

}  // namespace tendon::gui
