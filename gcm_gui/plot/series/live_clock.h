#pragma once

#include <cstdint>
#include <limits>

namespace tendon::gui {

/// The source's present time, guessed from samples that arrive in batches and late.
///
/// The freshest sample of the last seconds says how far the source's clock is ahead of ours; ours
/// carries on from there. So now() runs evenly between batches, and goes on when the source is
/// silent. All times in nanoseconds, each on its own steady clock.
class LiveClock {
 public:
  /// A sample of `newest_ns` has arrived at `local_ns`.
  void hear(std::int64_t newest_ns, std::int64_t local_ns);
  /// `local_ns` itself before the first sample.
  [[nodiscard]] std::int64_t now(std::int64_t local_ns) const;

 private:
  static constexpr std::int64_t kUnknown = std::numeric_limits<std::int64_t>::min();

  // The best lead of this span of time and of the one before: old ones are forgotten.
  std::int64_t lead_ns_ = kUnknown;
  std::int64_t former_lead_ns_ = kUnknown;
  std::int64_t span_began_ns_ = 0;
};

}  // namespace tendon::gui
