#include <gcm_gui/plot/series/sample_ring.h>

#include <gcm_gui/plot/series/time_shift.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <utility>

namespace tendon::gui {
namespace {

constexpr std::size_t kFirstCapacity = 1024;
// Limits the memory for gaps; a signal that loses every other row would have very many.
constexpr std::size_t kMaxGaps = 16384;
// A shorter time without samples is no standstill: it may be the normal distance between the
// samples of a slow source.
constexpr std::int64_t kShortestStandstillNs = 250'000'000;

std::size_t Capacity(std::size_t limit) { return std::bit_floor(std::max(limit, std::size_t{2})); }

}  // namespace

SampleRing::SampleRing(std::size_t limit) : limit_(Capacity(limit)) {
  reallocate(std::min(limit_, kFirstCapacity));
}

void SampleRing::append(std::span<const Sample> samples) {
  for (const Sample& sample : samples) {
    if (!takeKind(sample) || !continues(sample)) continue;
    last_tick_ = sample.tick;
    const std::int64_t newest = empty() ? sample.time_ns : time(end_ - 1);
    push(std::max(sample.time_ns, newest), sample.value.word());
  }
}

// Returns true if the sample has a number that must be stored. Adapts the number kind of the ring.
bool SampleRing::takeKind(const Sample& sample) {
  const ExactNumber::Kind kind = sample.value.kind();
  if (kind == kind_) return true;
  if (!sample.value.isFinite() && kind_ != ExactNumber::Kind::kReal) {
    // The row with this tick is not lost, but rows before it may be.
    if (!empty() && sample.tick > last_tick_) {
      lost_before_ += sample.tick - last_tick_ - 1;
      last_tick_ = sample.tick;
    }
    has_no_value_ = true;
    return false;
  }
  forgetUntil(end_);
  kind_ = kind;
  return true;
}

// Returns true if the sample belongs at the end of the ring. Records the gap before it.
bool SampleRing::continues(const Sample& sample) {
  if (empty()) {
    epoch_begins_ = has_no_value_ = stands_still_ = standstill_ends_ = false;
    lost_before_ = 0;
    base_index_ = end_;
    base_tick_ = sample.tick;
    return true;
  }
  const bool later = sample.time_ns > time(end_ - 1);
  if (epoch_begins_ || (sample.tick < last_tick_ && later)) {
    epoch_begins_ = false;
    if (sample.time_ns + kClockToleranceNs < time(end_ - 1)) forgetUntil(end_);
    if (empty()) return continues(sample);
    addGap(Gap::Cause::kRestart, sample);
    has_no_value_ = stands_still_ = standstill_ends_ = false;
    lost_before_ = 0;
    return true;
  }
  if (sample.tick <= last_tick_) {
    ++repeated_;
    return false;
  }
  const bool has_no_value = std::exchange(has_no_value_, false);
  const std::uint64_t lost = std::exchange(lost_before_, 0) + (sample.tick - last_tick_ - 1);
  const bool is_standstill =
      stands_still_ && sample.time_ns - time(end_ - 1) > kShortestStandstillNs;
  // The standstill has ended, because the source runs again. The next sample of a slow source may
  // come after an equally long time. This time must not count as another standstill.
  if (is_standstill) stands_still_ = standstill_ends_ = false;
  if (lost > 0) {
    addGap(Gap::Cause::kLost, sample, lost);
  } else if (is_standstill) {
    addGap(Gap::Cause::kStandstill, sample);
  } else if (has_no_value) {
    addGap(Gap::Cause::kNoValue, sample);
  }
  if (std::exchange(standstill_ends_, false)) stands_still_ = false;
  return true;
}

void SampleRing::addGap(Gap::Cause cause, const Sample& next, std::uint64_t lost) {
  lost_ += lost;
  const std::int64_t from = time(end_ - 1);
  gaps_.push_back({.cause = cause,
                   .index = end_,
                   .tick = next.tick,
                   .lost = lost,
                   .from_ns = from,
                   .to_ns = std::max(from, next.time_ns)});
  if (gaps_.size() > kMaxGaps) forgetUntil(gaps_.front().index);
}

void SampleRing::push(std::int64_t time_ns, std::uint64_t word) {
  if (end_ - first_ == times_.size()) {
    if (times_.size() < limit_) {
      reallocate(times_.size() * 2);
    } else {
      forgetUntil(first_ + 1);
    }
  }
  times_[end_ & mask()] = time_ns;
  words_[end_ & mask()] = word;
  ++end_;
}

void SampleRing::forgetUntil(std::uint64_t index) {
  first_ = std::max(first_, index);
  while (!gaps_.empty() && gaps_.front().index <= first_) {
    base_index_ = gaps_.front().index;
    base_tick_ = gaps_.front().tick;
    gaps_.pop_front();
  }
}

void SampleRing::move(std::int64_t by_ns) {
  for (std::uint64_t index = first_; index < end_; ++index) {
    std::int64_t& time_ns = times_[index & mask()];
    time_ns = MovedTime(time_ns, by_ns);
  }
  for (Gap& gap : gaps_) {
    gap.from_ns = MovedTime(gap.from_ns, by_ns);
    gap.to_ns = MovedTime(gap.to_ns, by_ns);
  }
}

void SampleRing::setLimit(std::size_t samples) {
  limit_ = Capacity(samples);
  if (times_.size() <= limit_) return;
  if (end_ - first_ > limit_) forgetUntil(end_ - limit_);
  reallocate(limit_);
}

void SampleRing::reallocate(std::size_t capacity) {
  std::vector<std::int64_t> times(capacity);
  std::vector<std::uint64_t> words(capacity);
  for (std::uint64_t index = first_; index < end_; ++index) {
    times[index & (capacity - 1)] = time(index);
    words[index & (capacity - 1)] = words_[index & mask()];
  }
  times_ = std::move(times);
  words_ = std::move(words);
}

std::uint64_t SampleRing::tick(std::uint64_t index) const {
  const auto after =
      std::upper_bound(gaps_.begin(), gaps_.end(), index,
                       [](std::uint64_t wanted, const Gap& gap) { return wanted < gap.index; });
  if (after == gaps_.begin()) return base_tick_ + (index - base_index_);
  const Gap& gap = *std::prev(after);
  return gap.tick + (index - gap.index);
}

std::uint64_t SampleRing::lowerBound(std::int64_t time_ns) const {
  std::uint64_t low = first_;
  std::uint64_t high = end_;
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    if (time(middle) < time_ns) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

SampleRing::Segment SampleRing::segment(std::uint64_t from, std::uint64_t to) const {
  const std::size_t offset = from & mask();
  const std::size_t count = std::min<std::size_t>(to - from, times_.size() - offset);
  return {.times = {times_.data() + offset, count}, .words = {words_.data() + offset, count}};
}

}  // namespace tendon::gui
