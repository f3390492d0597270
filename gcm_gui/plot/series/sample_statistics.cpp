#include <gcm_gui/plot/series/sample_statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tendon::gui {
namespace {

constexpr double kExactIntegers = 9007199254740992;  // 2^53

// Returns a factor that scales distances of this size to about 1, so that their squares fit a
// double.
double UnitOfSize(double size) {
  constexpr int kMinExponent = -1000;
  int exponent = 0;
  std::frexp(size, &exponent);
  return std::ldexp(1, -std::max(exponent, kMinExponent));
}

// Undoes the scaling of UnitOfSize(). Rounding cannot make the result infinite.
double FromUnit(double distance, double unit) {
  constexpr double kMax = std::numeric_limits<double>::max();
  return std::clamp(distance / unit, -kMax, kMax);
}

// Returns the integer at this distance above `lowest`, with more digits than a double has.
ExactNumber Above(const ExactNumber& lowest, double distance) {
  return {lowest.kind(), lowest.word() + static_cast<std::uint64_t>(std::round(distance))};
}

}  // namespace

SampleStatistics SampleStatistics::scaled(const Scaling& scaling) const {
  if (scaling.isNone()) return *this;
  SampleStatistics result = *this;
  double low = scaling.of(lowest.nearest());
  double high = scaling.of(highest.nearest());
  if (low > high) std::swap(low, high);
  result.lowest = low;
  result.highest = high;
  result.mean = scaling.of(mean.nearest());
  result.deviation = std::abs(scaling.factor) * deviation;
  result.rms = std::hypot(result.deviation, result.mean.nearest());
  return result;
}

ExactNumber SampleStatistics::span() const {
  if (lowest.isInteger()) return ExactNumber::Unsigned(highest.word() - lowest.word());
  return highest.nearest() - lowest.nearest();
}

std::optional<SampleStatistics> StatisticsOf(const SampleRing& ring, std::int64_t from_ns,
                                             std::int64_t to_ns) {
  const std::uint64_t first = ring.lowerBound(from_ns);
  const std::uint64_t end = ring.lowerBound(to_ns + 1);
  SampleStatistics result;
  for (std::uint64_t i = first; i < end; ++i) {
    const ExactNumber number = ring.number(i);
    if (!number.isFinite()) continue;
    if (++result.count == 1) result.lowest = result.highest = number;
    if (number.isBelow(result.lowest)) result.lowest = number;
    if (result.highest.isBelow(number)) result.highest = number;
  }
  if (result.count == 0) return std::nullopt;

  // Distances from the lowest integer are exact, but large integers as doubles are not. Real
  // numbers need no base.
  const double base = result.lowest.isInteger() ? result.lowest.nearest() : 0;
  const DistanceFrom distance_from(ring.kind(), base);
  const double lowest = distance_from(result.lowest.word());
  const double size = std::max(std::abs(lowest), std::abs(distance_from(result.highest.word())));
  const double unit = UnitOfSize(size);
  std::uint64_t count = 0;
  double mean = 0;
  double squares = 0;  // sum of the squared distances from the running mean (Welford)
  for (std::uint64_t i = first; i < end; ++i) {
    const ExactNumber number = ring.number(i);
    if (!number.isFinite()) continue;
    const double value = distance_from(number.word()) * unit;
    const double distance = value - mean;
    mean += distance / static_cast<double>(++count);
    squares += distance * (value - mean);
  }
  const double deviation = std::sqrt(squares / static_cast<double>(count));
  result.deviation = FromUnit(deviation, unit);
  const double from_base = FromUnit(mean, unit);
  const bool is_beyond_doubles = std::abs(base + from_base) >= kExactIntegers;
  result.mean = result.lowest.isInteger() && is_beyond_doubles
                    ? Above(result.lowest, from_base - lowest)
                    : ExactNumber(base + from_base);
  result.rms = base == 0 ? FromUnit(std::hypot(deviation, mean), unit)
                         : std::hypot(result.deviation, result.mean.nearest());
  result.rate = RateOf(ring, from_ns, to_ns);
  return result;
}

double RateOf(const SampleRing& ring, std::int64_t from_ns, std::int64_t to_ns) {
  const std::uint64_t first = ring.lowerBound(from_ns);
  const std::uint64_t end = ring.lowerBound(to_ns + 1);
  if (end <= first) return 0;
  const auto span_ns = static_cast<double>(ring.time(end - 1) - ring.time(first));
  return span_ns > 0 ? static_cast<double>(end - 1 - first) * 1e9 / span_ns : 0;
}

std::map<std::int64_t, std::uint64_t> OccurrencesOf(const SampleRing& ring, std::int64_t from_ns,
                                                    std::int64_t to_ns) {
  constexpr std::size_t kMax = 64;
  std::map<std::int64_t, std::uint64_t> occurrences;
  if (ring.kind() != ExactNumber::Kind::kSigned) return occurrences;
  const std::uint64_t end = ring.lowerBound(to_ns + 1);
  for (std::uint64_t i = ring.lowerBound(from_ns); i < end; ++i) {
    const auto value = static_cast<std::int64_t>(ring.number(i).word());
    const auto found = occurrences.find(value);
    if (found != occurrences.end()) {
      ++found->second;
    } else if (occurrences.size() < kMax) {
      occurrences.emplace(value, 1);
    }
  }
  return occurrences;
}

}  // namespace tendon::gui
