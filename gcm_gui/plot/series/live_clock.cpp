#include <gcm_gui/plot/series/live_clock.h>

#include <algorithm>

namespace tendon::gui {
namespace {

constexpr std::int64_t kSpanNs = 2'000'000'000;

}  // namespace

void LiveClock::update(std::int64_t newest_ns, std::int64_t local_ns) {
  const std::int64_t lead = newest_ns - local_ns;
  if (lead_ns_ == kUnknown || local_ns - span_began_ns_ > kSpanNs) {
    former_lead_ns_ = lead_ns_;
    lead_ns_ = lead;
    span_began_ns_ = local_ns;
  } else {
    lead_ns_ = std::max(lead_ns_, lead);
  }
}

std::int64_t LiveClock::now(std::int64_t local_ns) const {
  if (lead_ns_ == kUnknown) return local_ns;
  return local_ns + std::max(lead_ns_, former_lead_ns_);
}

}  // namespace tendon::gui
