#include <tendon/process/clock_offset.h>

#include <algorithm>

namespace tendon {
namespace {

using std::chrono::nanoseconds;

constexpr nanoseconds::rep kDrift = 10'000;  // clocks drift by at most 1 ns per 10000 ns
constexpr nanoseconds::rep kSlew = 2'000;    // the correction changes by at most 1 ns per 2000 ns
constexpr std::chrono::milliseconds kStep(128);

}  // namespace

SteadyTime ClockOffset::Sensible(SteadyTime time) {
  constexpr SteadyTime kLatest(std::chrono::hours(24 * 365 * 50));
  return std::clamp(time, SteadyTime(), kLatest);
}

void ClockOffset::Add(SteadyTime sent, SteadyTime there, SteadyTime arrived) {
  if (arrived < sent || there != Sensible(there)) return;
  const nanoseconds bound = (arrived - sent + nanoseconds(1)) / 2;
  const nanoseconds offset = there - (sent + (arrived - sent) / 2);
  if (const Estimate before = Best(arrived); before.uncertainty != kUnknown) {
    const nanoseconds apart = std::chrono::abs(offset - before.offset);
    if (apart > before.uncertainty + bound) count_ = 0;
  }
  const bool is_first = since_ == SteadyTime();
  measurements_[count_ % measurements_.size()] = {
      .offset = offset, .bound = bound, .arrived = arrived};
  ++count_;

  offset_ = SlewedAt(there);
  since_ = std::max(since_, there);
  target_ = At(arrived).offset;
  if (is_first || std::chrono::abs(target_ - offset_) > kStep) {
    offset_ = target_;
    since_ = there;
  }
}

ClockOffset::Estimate ClockOffset::At(SteadyTime now) const {
  Estimate best = Best(now);
  if (std::chrono::abs(best.offset) <= best.uncertainty) best.offset = nanoseconds(0);
  return best;
}

ClockOffset::Estimate ClockOffset::Best(SteadyTime now) const {
  Estimate best;
  for (std::size_t i = 0; i < std::min(count_, measurements_.size()); ++i) {
    const Measurement& measurement = measurements_[i];
    const nanoseconds aged =
        measurement.bound + std::max(now - measurement.arrived, nanoseconds(0)) / kDrift;
    if (aged < best.uncertainty) best = {.offset = measurement.offset, .uncertainty = aged};
  }
  return best;
}

nanoseconds ClockOffset::SlewedAt(SteadyTime there) const {
  const nanoseconds farthest = std::max(Sensible(there) - since_, nanoseconds(0)) / kSlew;
  return offset_ + std::clamp(target_ - offset_, -farthest, farthest);
}

}  // namespace tendon
