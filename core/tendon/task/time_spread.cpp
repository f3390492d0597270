#include <tendon/task/time_spread.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace tendon {

void TimeSpread::Add(std::chrono::nanoseconds time) noexcept {
  const auto value = static_cast<std::uint64_t>(std::max<std::int64_t>(time.count(), 0));
  if (count_ == 0) first_ = min_ = max_ = value;
  ++count_;
  min_ = std::min(min_, value);
  max_ = std::max(max_, value);
  const double difference = static_cast<double>(value) - static_cast<double>(first_);
  sum_ += difference;
  squares_ += difference * difference;
  ++buckets_[BucketOf(value)];
}

TimeStatistics TimeSpread::Summary() const noexcept {
  constexpr double kSecond = 1e9;
  if (count_ == 0) return {};
  const auto count = static_cast<double>(count_);
  const double mean = sum_ / count;
  const double variance =
      count_ < 2 ? 0.0 : std::max(0.0, (squares_ - sum_ * mean) / (count - 1.0));
  return {.mean = (static_cast<double>(first_) + mean) / kSecond,
          .deviation = std::sqrt(variance) / kSecond,
          .min = static_cast<double>(min_) / kSecond,
          .max = static_cast<double>(max_) / kSecond,
          .p50 = Percentile(0.50) / kSecond,
          .p99 = Percentile(0.99) / kSecond};
}

std::size_t TimeSpread::BucketOf(std::uint64_t time) noexcept {
  constexpr std::uint64_t kFine = std::uint64_t{1} << kSubBits;
  if (time < kFine) return time;
  const std::uint64_t value = std::min(time, (std::uint64_t{1} << kLongestBits) - 1);
  const unsigned shift = static_cast<unsigned>(std::bit_width(value)) - kSubBits - 1;
  return ((shift + 1) << kSubBits) + ((value >> shift) - kFine);
}

double TimeSpread::MiddleOf(std::size_t bucket) noexcept {
  constexpr std::size_t kFine = std::size_t{1} << kSubBits;
  if (bucket < kFine) return static_cast<double>(bucket);
  const std::size_t shift = (bucket >> kSubBits) - 1;
  const std::uint64_t low = (kFine + bucket % kFine) << shift;
  return static_cast<double>(low) + static_cast<double>(std::uint64_t{1} << shift) / 2.0;
}

double TimeSpread::Percentile(double part) const noexcept {
  const auto rank = static_cast<std::uint64_t>(std::ceil(part * static_cast<double>(count_)));
  std::uint64_t seen = 0;
  for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
    seen += buckets_[bucket];
    if (seen < rank) continue;
    return std::clamp(MiddleOf(bucket), static_cast<double>(min_), static_cast<double>(max_));
  }
  return static_cast<double>(max_);
}

}  // namespace tendon
