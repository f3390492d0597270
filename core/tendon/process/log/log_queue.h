#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/log.h>
#include <tendon/lockfree/flag.h>
#include <tendon/process/log/log_limiter.h>
#include <tendon/process/log/log_messages.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// Log records of this process that wait to be sent: as many of each source as LogLimiter admits,
/// and the newest of those. A record reports how many were suppressed, or were lost because the
/// queue was full.
///
/// Thread-safe. A thread waits for another at most while that copies a record.
class LogQueue {
 public:
  static constexpr std::size_t kCapacity = 1024;
  /// Longer texts are cut to this many bytes, and end with "...".
  static constexpr std::size_t kLongestText = 1024;

  explicit LogQueue(const Clock& clock = SteadyClock()) : clock_(clock) {}

  /// Returns whether the queue had no news before. Allocates.
  bool Add(LogLevel level, std::string_view source, std::string_view text);

  /// The oldest records, at most `most`, and one about lost ones. Reports suppressed records that
  /// are due at `now`; pass SteadyTime::max() in the last call.
  std::vector<message::LogRecord> Take(std::size_t most, SteadyTime now);

  /// Whether Take() will return records, now or within LogLimiter::kUntilTold. Wait-free.
  [[nodiscard]] bool has_news() const noexcept { return has_news_.Get(); }

 private:
  /// A record, and the number of logged records that are lost if it is.
  struct Waiting {
    message::LogRecord record;
    std::uint64_t stands_for = 1;
  };
  void Push(Waiting waiting);

  const Clock& clock_;
  std::mutex mutex_;
  LogLimiter limiter_;
  std::deque<Waiting> records_;
  std::uint64_t lost_ = 0;  // records not reported yet
  Flag has_news_{false};
};

}  // namespace tendon
