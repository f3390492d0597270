#pragma once

#include <cstdint>
#include <limits>

namespace tendon::gui {

/// Estimates the present time of the source from samples that arrive late and in batches.
///
/// The offset between the source's clock and the local clock is taken from the sample with the
/// least delay in the last seconds. Therefore, now() is smooth between batches, and continues when
/// the source sends nothing. All times are in nanoseconds, each on its own steady clock.
class LiveClock {
 public:
  /// Called when a sample with the time `newest_ns` has arrived at the local time `local_ns`.
  void update(std::int64_t newest_ns, std::int64_t local_ns);
  /// Returns the present time of the source; before the first sample, `local_ns`.
  [[nodiscard]] std::int64_t now(std::int64_t local_ns) const;

 private:
  static constexpr std::int64_t kUnknown = std::numeric_limits<std::int64_t>::min();

  // The maximum offset in the present interval and in the previous interval. An older offset has no
  // effect.
  std::int64_t lead_ns_ = kUnknown;
  std::int64_t former_lead_ns_ = kUnknown;
  std::int64_t span_began_ns_ = 0;
};

}  // namespace tendon::gui
