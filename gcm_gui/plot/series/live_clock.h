#pragma once

#include <cstdint>
#include <limits>

namespace tendon::gui {

/// Estimates the source's present time from samples that arrive late and in batches.
///
/// The sample of the last seconds that arrived with the least delay gives the offset between the
/// source's clock and ours. So now() is smooth between batches, and continues when the source is
/// silent. All times in nanoseconds, each on its own steady clock.
class LiveClock {
 public:
  /// A sample with time `newest_ns` has arrived at `local_ns`.
  void update(std::int64_t newest_ns, std::int64_t local_ns);
  /// Returns `local_ns` before the first sample.
  [[nodiscard]] std::int64_t now(std::int64_t local_ns) const;

 private:
  static constexpr std::int64_t kUnknown = std::numeric_limits<std::int64_t>::min();

  // The maximum offset in the present and in the previous interval, so that old offsets expire.
  std::int64_t lead_ns_ = kUnknown;
  std::int64_t former_lead_ns_ = kUnknown;
  std::int64_t span_began_ns_ = 0;
};

}  // namespace tendon::gui
