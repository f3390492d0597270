#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/log.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// Limits how many log records of each source are sent, so that one source with many records does
/// not displace others. Each source has a token bucket in the form of the generic cell rate
/// algorithm (ITU-T I.371, virtual scheduling), which stores only one time. Counts and reports the
/// suppressed records. Not thread-safe.
class LogLimiter {
 public:
  /// After a silence, allows `burst` records at once. Then allows one record in each `interval`.
  struct Rate {
    int burst = 200;
    std::chrono::nanoseconds interval = std::chrono::milliseconds(10);
  };
  /// The maximum number of sources with their own bucket. Further sources share the bucket kOthers
  /// until the bucket of a silent source is freed.
  static constexpr std::size_t kMaxSources = 256;
  static constexpr std::string_view kOthers = "others";
  /// Source names are compared up to this many bytes.
  static constexpr std::size_t kLongestSource = 64;
  /// Time from the first suppressed record to the report of the count.
  static constexpr std::chrono::seconds kUntilReport{1};

  LogLimiter() : LogLimiter(Rate{}) {}
  explicit LogLimiter(Rate rate) : rate_(rate) {}

  /// Returns true if a record of this source may be sent now; otherwise counts it as suppressed.
  bool Admit(std::string_view source, LogLevel level, SteadyTime now);

  /// The suppressed records of one source.
  struct SuppressedCount {
    std::string source;
    LogLevel level = LogLevel::kDebug;  ///< the highest level of these records
    std::uint64_t count = 0;

    bool operator==(const SuppressedCount&) const = default;
  };
  /// Removes and returns the counts that are due. Pass SteadyTime::max() to get all counts.
  std::vector<SuppressedCount> TakeSuppressed(SteadyTime now);
  /// True if there are suppressed records to report, now or later.
  [[nodiscard]] bool owes() const { return owing_ > 0; }

 private:
  struct Bucket {
    SteadyTime due{};  // time of the next record at an even rate
    std::uint64_t suppressed = 0;
    LogLevel level = LogLevel::kDebug;
    SteadyTime since{};  // time of the first suppressed record
  };

  Bucket& BucketOf(std::string_view source, SteadyTime now);

  const Rate rate_;
  std::map<std::string, Bucket, std::less<>> buckets_;
  SteadyTime next_sweep_{};
  std::size_t owing_ = 0;  // buckets with suppressed records
};

}  // namespace tendon
