#include <gcm_gui/plot/series/curve.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/series/time_shift.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace tendon::gui {
namespace {

constexpr std::int64_t kSecondNs = 1'000'000'000;

}  // namespace

QString WaitingFor(const QString& path) {
  if (!RecordingOf(path).isEmpty()) return Words::tr("nothing recorded at this time");
  return Words::tr("waiting for ") + SourceOf(path);
}

Curve::Curve(CurveKey key, int color_index)
    : key_(std::move(key)),
      recording_(RecordingOf(key_.path)),
      color_index_(color_index),
      stale_reason_(WaitingFor(key_.path)) {}

void Curve::setShift(std::int64_t shift_ns) {
  if (shift_ns == shift_ns_) return;
  samples_.move(shift_ns - shift_ns_);
  shift_ns_ = shift_ns;
  drawn_ = {};
}

void Curve::append(std::span<const Sample> samples) {
  if (samples.empty()) return;
  history_.append(samples);
  if (shift_ns_ == 0) {
    samples_.append(samples);
  } else {
    std::vector<Sample> moved(samples.begin(), samples.end());
    for (Sample& sample : moved) sample.time_ns = MovedTime(sample.time_ns, shift_ns_);
    samples_.append(moved);
  }
  stale_reason_.clear();
}

void Curve::removeSamples() {
  samples_.clear();
  history_.clear();
  drawn_ = {};
  stale_reason_ = WaitingFor(path());
}

void Curve::setStandstill(const QString& why) {
  if (!why.isEmpty()) samples_.noteStandstill();
  if (why.isEmpty() && isStandingStill()) samples_.endStandstill();
  standstill_ = why;
}

void Curve::setBudget(std::size_t bytes) {
  constexpr std::size_t kPartOfHistory = 8;
  const std::size_t for_history = bytes / kPartOfHistory;
  history_.setLimit(for_history / CoarseHistory::kBytesPerBucket);
  samples_.setLimit((bytes - for_history) / SampleRing::kBytesPerSample);
}

void Curve::setLook(const CurveLook& look) {
  look_ = look;
  drawn_ = {};
}

void Curve::setBase(double base) {
  if (base == base_) return;
  base_ = base;
  drawn_ = {};
}

bool Curve::isThinned() const { return samples_.firstIndex() > 0 && !samples_.empty(); }

// Adds the part before the oldest sample to the envelope.
void Curve::showHistory(Envelope& envelope, const TimeSlices& slices, double base) const {
  if (!isThinned()) return;
  const std::int64_t until = MovedTime(samples_.time(samples_.firstIndex()), -shift_ns_);
  const std::int64_t from = MovedTime(slices.from_ns, -shift_ns_) - CoarseHistory::kWidthNs;
  const auto& buckets = history_.buckets();
  const DistanceFrom distance(history_.kind(), base);
  const auto first = std::upper_bound(
      buckets.begin(), buckets.end(), from,
      [](std::int64_t time_ns, const auto& bucket) { return time_ns < bucket.from_ns; });
  for (auto each = first; each != buckets.end() && each->from_ns < until; ++each) {
    const std::int64_t end = std::min(each->from_ns + CoarseHistory::kWidthNs, until);
    envelope.widen(MovedTime(each->from_ns, shift_ns_), MovedTime(end, shift_ns_),
                   distance(each->low), distance(each->high));
  }
}

ExactNumber Curve::shown(std::uint64_t index) const {
  const ExactNumber number = samples_.number(index);
  return scaling().isNone() ? number : scaling().of(number.nearest());
}

double Curve::distanceOf(std::uint64_t index) const {
  const ExactNumber number = shown(index);
  return DistanceFrom(number.kind(), base_)(number.word());
}

std::optional<ExactNumber> Curve::numberAt(std::int64_t time_ns) const {
  const std::uint64_t next = samples_.lowerBound(time_ns + 1);
  if (next == samples_.firstIndex()) return {};
  if (time_ns > MovedTime(recorded_end_ns_, shift_ns_)) return {};
  const auto& gaps = samples_.gaps();
  const bool in_gap = std::any_of(gaps.begin(), gaps.end(), [&](const Gap& gap) {
    return gap.from_ns < time_ns && time_ns < gap.to_ns;
  });
  if (in_gap) return {};
  const bool is_newest = next == samples_.endIndex();
  if (is_newest && isStale()) return {};
  if (is_newest && isStandingStill() && time_ns > samples_.time(next - 1)) return {};
  return shown(next - 1);
}

std::optional<ExactNumber> Curve::latestNumber() const {
  if (samples_.empty()) return {};
  return shown(samples_.endIndex() - 1);
}

double Curve::rate() const {
  const std::uint64_t end = samples_.endIndex();
  if (end - samples_.firstIndex() < 2) return 0;
  const std::int64_t newest = samples_.time(end - 1);
  const std::uint64_t first = std::min(samples_.lowerBound(newest - kSecondNs), end - 2);
  const std::int64_t span = newest - samples_.time(first);
  if (span <= 0) return 0;
  return static_cast<double>(end - 1 - first) * kSecondNs / static_cast<double>(span);
}

const Envelope& Curve::envelope(const TimeSlices& slices, Pass pass) const {
  DrawnEnvelope& drawn = drawn_[static_cast<std::size_t>(pass)];
  if (slices != drawn.slices || samples_.endIndex() != drawn.end) {
    const double base = scaling().isNone() ? base_ : 0;
    drawn.envelope.build(samples_, slices, base);
    showHistory(drawn.envelope, slices, base);
    drawn.slices = slices;
    drawn.end = samples_.endIndex();
    if (!scaling().isNone()) drawn.scaled.takeScaled(drawn.envelope, scaling(), base_);
  }
  return scaling().isNone() ? drawn.envelope : drawn.scaled;
}

}  // namespace tendon::gui
