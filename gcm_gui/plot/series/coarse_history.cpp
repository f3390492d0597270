#include <gcm_gui/plot/series/coarse_history.h>

#include <algorithm>

namespace tendon::gui {
namespace {

std::int64_t BucketOf(std::int64_t time_ns) {
  const std::int64_t rest = time_ns % CoarseHistory::kWidthNs;
  return time_ns - rest - (rest < 0 ? CoarseHistory::kWidthNs : 0);
}

}  // namespace

void CoarseHistory::append(std::span<const Sample> samples) {
  for (const Sample& sample : samples) {
    if (!sample.value.isFinite()) continue;
    if (sample.value.kind() != kind_) buckets_.clear();
    kind_ = sample.value.kind();
    const std::int64_t from = BucketOf(sample.time_ns);
    if (!buckets_.empty() && from + kClockToleranceNs < buckets_.back().from_ns) buckets_.clear();
    if (buckets_.empty() || from > buckets_.back().from_ns) {
      buckets_.push_back(
          {.from_ns = from, .low = sample.value.word(), .high = sample.value.word()});
      if (buckets_.size() > limit_) buckets_.pop_front();
      continue;
    }
    Bucket& newest = buckets_.back();
    if (sample.value.isBelow({kind_, newest.low})) newest.low = sample.value.word();
    if (ExactNumber(kind_, newest.high).isBelow(sample.value)) newest.high = sample.value.word();
  }
}

void CoarseHistory::setLimit(std::size_t buckets) {
  limit_ = std::max<std::size_t>(buckets, 1);
  while (buckets_.size() > limit_) buckets_.pop_front();
}

}  // namespace tendon::gui
