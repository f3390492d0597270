#include <tendon/process/log/log_limiter.h>

#include <algorithm>
#include <utility>

namespace tendon {

bool LogLimiter::Admit(std::string_view source, LogLevel level, SteadyTime now) {
  Bucket& bucket = BucketOf(source.substr(0, kLongestSource), now);
  if (now >= bucket.due - (rate_.burst - 1) * rate_.interval) {
    bucket.due = std::max(bucket.due, now) + rate_.interval;
    return true;
  }
  if (bucket.suppressed == 0) {
    ++owing_;
    bucket.since = now;
    bucket.level = level;
  }
  ++bucket.suppressed;
  bucket.level = std::max(bucket.level, level);
  return false;
}

std::vector<LogLimiter::SuppressedCount> LogLimiter::TakeSuppressed(SteadyTime now) {
  std::vector<SuppressedCount> suppressed;
  if (owing_ == 0) return suppressed;
  for (auto& [source, bucket] : buckets_) {
    if (bucket.suppressed == 0 || now - bucket.since < kUntilReport) continue;
    suppressed.push_back({source, bucket.level, std::exchange(bucket.suppressed, 0)});
    --owing_;
  }
  return suppressed;
}

LogLimiter::Bucket& LogLimiter::BucketOf(std::string_view source, SteadyTime now) {
  if (const auto found = buckets_.find(source); found != buckets_.end()) return found->second;
  if (buckets_.size() >= kMaxSources && now >= next_sweep_) {
    std::erase_if(buckets_, [now](const auto& one) {
      // This bucket equals a new bucket.
      return one.second.due <= now && one.second.suppressed == 0;
    });
    next_sweep_ = now + kUntilReport;
  }
  const bool has_room = buckets_.size() < kMaxSources;
  return buckets_[std::string(has_room ? source : kOthers)];
}

}  // namespace tendon
