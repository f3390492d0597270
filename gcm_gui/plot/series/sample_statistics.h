#pragma once

#include <gcm_gui/plot/series/exact_number.h>
#include <gcm_gui/plot/series/sample_ring.h>
#include <gcm_gui/plot/series/scaling.h>

#include <cstdint>
#include <map>
#include <optional>

namespace tendon::gui {

/// The statistics of the samples in a time span. Samples that are not finite are ignored.
struct SampleStatistics {
  std::uint64_t count = 0;
  ExactNumber lowest;
  ExactNumber highest;
  ExactNumber mean;      ///< rounded to an integer if a double near the mean cannot hold fractions
  double deviation = 0;  ///< standard deviation of the population
  double rms = 0;
  double rate = 0;  ///< samples per second; 0 if there are fewer than two

  /// Returns the statistics of the same samples after scaling.
  [[nodiscard]] SampleStatistics scaled(const Scaling& scaling) const;
  /// Returns maximum minus minimum; infinite if a double cannot hold it.
  [[nodiscard]] ExactNumber span() const;
};

/// Computes the statistics of the samples in [from_ns, to_ns]; empty if there are none. O(samples
/// in that span).
[[nodiscard]] std::optional<SampleStatistics> StatisticsOf(const SampleRing& ring,
                                                           std::int64_t from_ns,
                                                           std::int64_t to_ns);

/// Returns the samples per second in [from_ns, to_ns], including samples that are not finite; 0 if
/// there are fewer than two. O(log n).
[[nodiscard]] double RateOf(const SampleRing& ring, std::int64_t from_ns, std::int64_t to_ns);

/// Counts how often each value occurs in [from_ns, to_ns]. The values are states (signed integers).
/// After the first 64 different values, other values are not counted. O(samples in that span).
[[nodiscard]] std::map<std::int64_t, std::uint64_t> OccurrencesOf(const SampleRing& ring,
                                                                  std::int64_t from_ns,
                                                                  std::int64_t to_ns);

}  // namespace tendon::gui
