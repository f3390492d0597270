#include <tendon/base/axis_ticks.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <type_traits>

namespace tendon {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kAir = 0.1;  // margin around a constant value, relative to the value
constexpr double kTolerance = 1e-9;
/// The finest step, relative to the values on the axis: 1/8 of the spacing of doubles.
constexpr double kFinest = 0x1p-55;
constexpr std::size_t kShort = 9;  // characters; a label of at most this length has no exponent
constexpr std::array<std::int64_t, 3> kFactors{1, 2, 5};

/// The number factor * 10^exponent. Labels must be exact, but a double cannot hold most of these
/// numbers exactly.
struct Decimal {
  std::int64_t factor = 0;
  int exponent = 0;

  /// The nearest double; infinite if it is out of range.
  [[nodiscard]] double real() const {
    const std::string text = std::to_string(factor) + 'e' + std::to_string(exponent);
    double value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec == std::errc()) return value;
    if (exponent < 0) return 0;
    return factor < 0 ? -std::numeric_limits<double>::infinity()
                      : std::numeric_limits<double>::infinity();
  }
};

/// Returns for example "-1500" or "0.250".
std::string PlainText(const Decimal& number) {
  std::string digits = std::to_string(std::abs(number.factor));
  if (number.exponent > 0 && number.factor != 0) {
    digits.append(static_cast<std::size_t>(number.exponent), '0');
  } else if (number.exponent < 0) {
    const auto decimals = static_cast<std::size_t>(-number.exponent);
    if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
    digits.insert(digits.size() - decimals, 1, '.');
  }
  return number.factor < 0 ? '-' + digits : digits;
}

/// Returns for example "-1.5e+03" or "2.5e-01".
std::string ExponentText(const Decimal& number) {
  if (number.factor == 0) return "0";
  std::string digits = std::to_string(std::abs(number.factor));
  const int exponent = number.exponent + static_cast<int>(digits.size()) - 1;
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.size() > 1) digits.insert(1, 1, '.');
  const std::string size = std::to_string(std::abs(exponent));
  return (number.factor < 0 ? "-" : "") + digits + (exponent < 0 ? "e-" : "e+") +
         (size.size() < 2 ? "0" : "") + size;
}

/// Returns (high - low) / parts, computed without overflow.
double SpanOver(const AxisSpan<double>& span, double parts) {
  return span.high / parts - span.low / parts;
}

/// Returns the smallest step that fits into the span at most `most` times. The step is 1, 2 or 5
/// times a power of ten, and not below the resolution of doubles of this magnitude.
Decimal StepOf(const AxisSpan<double>& span, int most) {
  const double size = std::max(std::abs(span.low), std::abs(span.high));
  const double least = std::max({SpanOver(span, std::max(most, 2)), size * kFinest,
                                 std::numeric_limits<double>::denorm_min()});
  Decimal step{.factor = 1, .exponent = static_cast<int>(std::floor(std::log10(least)))};
  while (true) {
    for (const std::int64_t factor : kFactors) {
      step.factor = factor;
      if (step.real() >= least * (1 - kTolerance)) return step;
    }
    ++step.exponent;
  }
}

/// Returns `count` times the step.
Decimal Multiple(const Decimal& step, std::int64_t count) {
  return {.factor = step.factor * count, .exponent = step.exponent};
}

/// Returns the largest count such that count * step <= value. The division gives only a first
/// guess, because a denormal step differs from the decimal digits of its label.
std::int64_t StepsBelow(double value, const Decimal& step) {
  const auto is_above = [&](std::int64_t count) { return Multiple(step, count).real() > value; };
  auto low = static_cast<std::int64_t>(std::floor(value / step.real()));
  for (std::int64_t stride = 1; is_above(low); stride *= 2) low -= stride;
  std::int64_t high = low + 1;
  for (std::int64_t stride = 1; !is_above(high); stride *= 2) high += stride;
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (is_above(middle) ? high : low) = middle;
  }
  return low;
}

/// Returns high - low. The result is unsigned, so that it can hold the whole range of the type.
template <std::integral Integer>
std::uint64_t Distance(Integer low, Integer high) {
  return static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low);
}

template <std::integral Integer>
std::uint64_t IntegerStepOf(const AxisSpan<Integer>& span, int most) {
  const auto parts = static_cast<std::uint64_t>(std::max(most, 2));
  const std::uint64_t distance = Distance(span.low, span.high);
  const std::uint64_t least = distance / parts + (distance % parts == 0 ? 0 : 1);
  constexpr std::uint64_t kLast = 10'000'000'000'000'000'000U;
  for (std::uint64_t power = 1;; power *= 10) {
    for (const std::int64_t factor : kFactors) {
      if (power == kLast && factor > 1) return kLast;
      const std::uint64_t step = power * static_cast<std::uint64_t>(factor);
      if (step >= least) return step;
    }
  }
}

/// Returns the distance from `value` down to the next multiple of `step`.
template <std::integral Integer>
std::uint64_t Remainder(Integer value, std::uint64_t step) {
  const auto bits = static_cast<std::uint64_t>(value);
  if (value >= 0) return bits % step;
  const std::uint64_t rest = (0 - bits) % step;
  return rest == 0 ? 0 : step - rest;
}

template <std::integral Integer>
Integer Plus(Integer value, std::uint64_t distance) {
  return static_cast<Integer>(static_cast<std::uint64_t>(value) + distance);
}

template <std::integral Integer>
AxisSpan<Integer> FittedToTicks(const AxisSpan<Integer>& span, int most) {
  using Limits = std::numeric_limits<Integer>;
  const std::uint64_t step = IntegerStepOf(span, most);
  const std::uint64_t below = Remainder(span.low, step);
  const std::uint64_t rest = Remainder(span.high, step);
  const std::uint64_t above = rest == 0 ? 0 : step - rest;
  const bool has_below = below <= Distance(Limits::min(), span.low);
  const bool has_above = above <= Distance(span.high, Limits::max());
  return {.low = has_below ? Plus(span.low, 0 - below) : Limits::min(),
          .high = has_above ? Plus(span.high, above) : Limits::max()};
}

template <std::integral Integer>
std::vector<AxisTick<Integer>> TicksOfOneStep(const AxisSpan<Integer>& span, int most) {
  const std::uint64_t step = IntegerStepOf(span, most);
  const std::uint64_t rest = Remainder(span.low, step);
  const std::uint64_t distance = Distance(span.low, span.high);
  std::vector<AxisTick<Integer>> ticks;
  for (std::uint64_t at = rest == 0 ? 0 : step - rest; at <= distance;) {
    const Integer value = Plus(span.low, at);
    ticks.push_back({.value = value, .label = std::to_string(value)});
    if (step > distance - at) break;  // the next tick is beyond the axis, and `at` may overflow
    at += step;
  }
  return ticks;
}

AxisSpan<double> WidenedReals(double low, double high) {
  const double size = std::max(std::abs(low), std::abs(high));
  const bool is_at_rest = size < kLargestZero || high / 2 - low / 2 < size / 2 * kRounding;
  if (!is_at_rest) return {.low = low, .high = high};
  if (size < kLargestZero) return {.low = -1, .high = 1};
  const double middle = low / 2 + high / 2;
  const double half = size * kAir;
  return {.low = std::max(middle - half, -kLargest), .high = std::min(middle + half, kLargest)};
}

AxisSpan<double> FittedToTicks(const AxisSpan<double>& span, int most) {
  const Decimal step = StepOf(span, most);
  const std::int64_t first = StepsBelow(span.low, step);
  std::int64_t last = StepsBelow(span.high, step);
  if (Multiple(step, last).real() < span.high) ++last;
  return {.low = std::max(Multiple(step, first).real(), -kLargest),
          .high = std::min(Multiple(step, last).real(), kLargest)};
}

/// Returns the labels, all in the same notation. They have exponents only if the plain notation is
/// longer than kShort and longer than the notation with exponents.
std::vector<std::string> LabelsOf(const std::vector<Decimal>& numbers) {
  std::vector<std::string> fixed;
  std::vector<std::string> exponents;
  std::size_t longest = 0;
  std::size_t longest_exponent = 0;
  for (const Decimal& number : numbers) {
    fixed.push_back(PlainText(number));
    exponents.push_back(ExponentText(number));
    longest = std::max(longest, fixed.back().size());
    longest_exponent = std::max(longest_exponent, exponents.back().size());
  }
  return longest <= std::max(kShort, longest_exponent) ? fixed : exponents;
}

std::vector<AxisTick<double>> TicksOfOneStep(const AxisSpan<double>& span, int most) {
  const Decimal step = StepOf(span, most);
  std::vector<Decimal> numbers;
  std::vector<AxisTick<double>> ticks;
  for (std::int64_t count = StepsBelow(span.low, step);; ++count) {
    const Decimal number = Multiple(step, count);
    const double value = number.real();
    if (value > span.high) break;
    if (value < span.low || (!ticks.empty() && value == ticks.back().value)) continue;
    numbers.push_back(number);
    ticks.push_back({.value = value, .label = {}});
  }
  const std::vector<std::string> labels = LabelsOf(numbers);
  for (std::size_t i = 0; i < ticks.size(); ++i) ticks[i].label = labels[i];
  return ticks;
}

}  // namespace

template <AxisNumber Number>
AxisSpan<Number> WidenedSpan(Number low, Number high) {
  if constexpr (std::is_integral_v<Number>) {
    if (low < high) return {.low = low, .high = high};
    using Limits = std::numeric_limits<Number>;
    return {.low = low > Limits::min() ? low - 1 : low,
            .high = high < Limits::max() ? high + 1 : high};
  } else {
    return WidenedReals(low, high);
  }
}

template <AxisNumber Number>
AxisSpan<Number> FittedSpan(Number low, Number high, int most) {
  return FittedToTicks(WidenedSpan(low, high), most);
}

template <AxisNumber Number>
std::vector<AxisTick<Number>> TicksOf(const AxisSpan<Number>& span, int most) {
  if (!(span.low < span.high)) return {};
  while (true) {
    auto ticks = TicksOfOneStep(span, most);
    if (!ticks.empty()) return ticks;
    most = 2 * std::max(most, 2);  // the axis lies between two ticks and needs a finer step
  }
}

template <AxisNumber Number>
double PartOf(const AxisSpan<Number>& span, Number value) {
  if (value <= span.low) return 0;
  if (value >= span.high) return 1;
  if constexpr (std::is_integral_v<Number>) {
    return static_cast<double>(Distance(span.low, value)) /
           static_cast<double>(Distance(span.low, span.high));
  } else {
    const double whole = span.high - span.low;
    if (std::isfinite(whole)) return (value - span.low) / whole;
    return (value / 2 - span.low / 2) / SpanOver(span, 2);
  }
}

template AxisSpan<double> WidenedSpan(double, double);
template AxisSpan<std::int64_t> WidenedSpan(std::int64_t, std::int64_t);
template AxisSpan<std::uint64_t> WidenedSpan(std::uint64_t, std::uint64_t);
template AxisSpan<double> FittedSpan(double, double, int);
template AxisSpan<std::int64_t> FittedSpan(std::int64_t, std::int64_t, int);
template AxisSpan<std::uint64_t> FittedSpan(std::uint64_t, std::uint64_t, int);
template std::vector<AxisTick<double>> TicksOf(const AxisSpan<double>&, int);
template std::vector<AxisTick<std::int64_t>> TicksOf(const AxisSpan<std::int64_t>&, int);
template std::vector<AxisTick<std::uint64_t>> TicksOf(const AxisSpan<std::uint64_t>&, int);
template double PartOf(const AxisSpan<double>&, double);
template double PartOf(const AxisSpan<std::int64_t>&, std::int64_t);
template double PartOf(const AxisSpan<std::uint64_t>&, std::uint64_t);

}  // namespace tendon
