#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/log.h>
#include <tendon/lockfree/flag.h>
#include <tendon/process/log/log_limiter.h>
#include <tendon/process/log/messages.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// Records of this process that wait to be sent: so many of each source as LogLimiter lets through,
/// and of those the newest. Nothing is lost in silence: a record says how many were suppressed, or
/// lost because nobody took them.
///
/// Thread-safe. Nobody waits for another longer than a record takes to be copied.
class LogQueue {
 public:
  static constexpr std::size_t kCapacity = 1024;
  /// Bytes of a text that are kept; "..." stands for the others.
  static constexpr std::size_t kLongestText = 1024;

  explicit LogQueue(const Clock& clock = SteadyClock()) : clock_(clock) {}

  /// Whether there was no news before. Allocates.
  bool Add(LogLevel level, std::string_view source, std::string_view text);

  /// The oldest, at most `most` and one about the lost. What was suppressed is told by the time
  /// `now`; SteadyTime::max() for what is the last.
  std::vector<message::LogRecord> Take(std::size_t most, SteadyTime now);

  /// Whether Take() will have something, now or within LogLimiter::kUntilTold. Wait-free.
  [[nodiscard]] bool has_news() const noexcept { return has_news_.Get(); }

 private:
  /// A record, and how many of those that were logged are lost with it.
  struct Waiting {
    message::LogRecord record;
    std::uint64_t stands_for = 1;
  };
  void Push(Waiting waiting);

  const Clock& clock_;
  std::mutex mutex_;
  LogLimiter limiter_;
  std::deque<Waiting> records_;
  std::uint64_t lost_ = 0;  // and not told
  Flag has_news_{false};
};

}  // namespace tendon
