#include <gcm_gui/plot/series/statistics.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tendon::gui {

Statistics Statistics::scaled(const Scaling& scaling) const {
  Statistics result = *this;
  std::tie(result.lowest, result.highest) = std::minmax({scaling.of(lowest), scaling.of(highest)});
  result.mean = scaling.of(mean);
  result.deviation = std::abs(scaling.factor) * deviation;
  result.rms = std::hypot(result.deviation, result.mean);
  return result;
}

std::optional<Statistics> StatisticsOf(const SampleRing& ring, std::int64_t from_ns,
                                       std::int64_t to_ns) {
  const std::uint64_t first = ring.lowerBound(from_ns);
  const std::uint64_t end = ring.lowerBound(to_ns + 1);
  Statistics result;
  double squares = 0;  // of the distances from the mean so far, after Welford
  for (std::uint64_t i = first; i < end; ++i) {
    const double value = ring.value(i);
    if (!std::isfinite(value)) continue;
    if (++result.count == 1) result.lowest = result.highest = value;
    result.lowest = std::min(result.lowest, value);
    result.highest = std::max(result.highest, value);
    const double distance = value - result.mean;
    result.mean += distance / static_cast<double>(result.count);
    squares += distance * (value - result.mean);
  }
  if (result.count == 0) return std::nullopt;
  const double variance = squares / static_cast<double>(result.count);
  result.deviation = std::sqrt(variance);
  result.rms = std::sqrt(variance + result.mean * result.mean);
  const auto span_ns = static_cast<double>(ring.time(end - 1) - ring.time(first));
  if (span_ns > 0) result.rate = static_cast<double>(end - 1 - first) * 1e9 / span_ns;
  return result;
}

}  // namespace tendon::gui
