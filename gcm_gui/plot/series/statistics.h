#pragma once

#include <gcm_gui/plot/scaling/scaling.h>
#include <gcm_gui/plot/series/sample_ring.h>

#include <cstdint>
#include <optional>

namespace tendon::gui {

/// Of the samples of a part of time; those that are not finite are left out.
struct Statistics {
  std::uint64_t count = 0;
  double lowest = 0;
  double highest = 0;
  double mean = 0;
  double deviation = 0;  ///< standard deviation of the population
  double rms = 0;
  double rate = 0;  ///< samples a second; 0 with less than two

  /// Of the same samples, scaled.
  [[nodiscard]] Statistics scaled(const Scaling& scaling) const;
  [[nodiscard]] double span() const { return highest - lowest; }
};

/// Of the samples in [from_ns, to_ns]; nothing when there are none. O(samples there).
[[nodiscard]] std::optional<Statistics> StatisticsOf(const SampleRing& ring, std::int64_t from_ns,
                                                     std::int64_t to_ns);

}  // namespace tendon::gui
