#pragma once

#include <gcm_gui/plot/series/exact_number.h>
#include <gcm_gui/plot/series/sample_ring.h>
#include <gcm_gui/plot/series/scaling.h>

#include <cstdint>
#include <map>
#include <optional>

namespace tendon::gui {

/// Statistics of the samples in a time span, without those that are not finite.
struct Statistics {
  std::uint64_t count = 0;
  ExactNumber lowest;
  ExactNumber highest;
  ExactNumber mean;      ///< rounded to an integer if doubles cannot distinguish its neighbours
  double deviation = 0;  ///< standard deviation of the population
  double rms = 0;
  double rate = 0;  ///< samples per second; 0 with less than two

  /// The statistics of the same samples, scaled.
  [[nodiscard]] Statistics scaled(const Scaling& scaling) const;
  /// Maximum minus minimum. Infinite if it does not fit a double.
  [[nodiscard]] ExactNumber span() const;
};

/// For the samples in [from_ns, to_ns]; empty if there are none. O(samples in that span).
[[nodiscard]] std::optional<Statistics> StatisticsOf(const SampleRing& ring, std::int64_t from_ns,
                                                     std::int64_t to_ns);

/// Samples per second in that span, including those that are not finite; 0 with less than two.
/// O(log n).
[[nodiscard]] double RateOf(const SampleRing& ring, std::int64_t from_ns, std::int64_t to_ns);

/// Counts how often each value occurs in that span, for states (signed integers). Counts at most
/// the first 64 different values. O(samples in that span).
[[nodiscard]] std::map<std::int64_t, std::uint64_t> OccurrencesOf(const SampleRing& ring,
                                                                  std::int64_t from_ns,
                                                                  std::int64_t to_ns);

}  // namespace tendon::gui
