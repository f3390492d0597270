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

/// How many records of each source go out, so that one that raves drowns no other: a token bucket a
/// source, as the generic cell rate algorithm (ITU-T I.371, virtual scheduling), which keeps one
/// time instead of a level and a time. What may not go out is counted, and told. Not thread-safe.
class LogLimiter {
 public:
  /// After a silence `burst` records at once; then one in each `interval`.
  struct Rate {
    int burst = 200;
    std::chrono::nanoseconds interval = std::chrono::milliseconds(10);
  };
  /// Sources beyond these share one bucket, that of kOthers, until others have been silent.
  static constexpr std::size_t kMostSources = 256;
  static constexpr std::string_view kOthers = "others";
  /// Bytes of a source's name that tell it from others.
  static constexpr std::size_t kLongestSource = 64;
  /// So long after the first that may not go out the count of them is told.
  static constexpr std::chrono::seconds kUntilTold{1};

  LogLimiter() : LogLimiter(Rate{}) {}
  explicit LogLimiter(Rate rate) : rate_(rate) {}

  /// Whether a record of this source may go out now; otherwise it is counted.
  bool Admit(std::string_view source, LogLevel level, SteadyTime now);

  /// Records of one source that did not go out.
  struct Suppressed {
    std::string source;
    LogLevel level = LogLevel::kDebug;  ///< the highest of them
    std::uint64_t count = 0;

    bool operator==(const Suppressed&) const = default;
  };
  /// Those to be told now; SteadyTime::max() means all.
  std::vector<Suppressed> TakeSuppressed(SteadyTime now);
  /// Whether there are some to be told, now or later.
  [[nodiscard]] bool owes() const { return owing_ > 0; }

 private:
  struct Bucket {
    SteadyTime due{};  // when the next record would come if they came evenly
    std::uint64_t suppressed = 0;
    LogLevel level = LogLevel::kDebug;
    SteadyTime since{};  // the first suppressed one
  };

  Bucket& BucketOf(std::string_view source, SteadyTime now);

  const Rate rate_;
  std::map<std::string, Bucket, std::less<>> buckets_;
  SteadyTime next_sweep_{};
  std::size_t owing_ = 0;  // buckets with suppressed records
};

}  // namespace tendon
