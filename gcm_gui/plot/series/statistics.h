#pragma once

#include <gcm_gui/plot/scaling/scaling.h>
#include <gcm_gui/plot/series/exact_number.h>
#include <gcm_gui/plot/series/sample_ring.h>

#include <cstdint>
#include <map>
#include <optional>

namespace tendon::gui {

/// Of the samples of a part of time; those that are not finite are left out.
struct Statistics {
  std::uint64_t count = 0;
  ExactNumber lowest;
  ExactNumber highest;
  ExactNumber mean;      ///< an integer where doubles cannot tell it from its neighbours
  double deviation = 0;  ///< standard deviation of the population
  double rms = 0;
  double rate = 0;  ///< samples a second; 0 with less than two

  /// Of the same samples, scaled.
  [[nodiscard]] Statistics scaled(const Scaling& scaling) const;
  /// From the lowest to the highest. Infinite where it does not fit a double.
  [[nodiscard]] ExactNumber span() const;
};

/// Of the samples in [from_ns, to_ns]; nothing when there are none. O(samples there).
[[nodiscard]] std::optional<Statistics> StatisticsOf(const SampleRing& ring, std::int64_t from_ns,
                                                     std::int64_t to_ns);

/// How often each value occurs among them, for states: numbers that are signed integers. Of more
/// than 64 different ones, the first 64. O(samples there).
[[nodiscard]] std::map<std::int64_t, std::uint64_t> OccurrencesOf(const SampleRing& ring,
                                                                  std::int64_t from_ns,
                                                                  std::int64_t to_ns);

}  // namespace tendon::gui
