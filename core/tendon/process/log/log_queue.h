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

/// Log records of this process that wait to be sent. LogLimiter limits the records of each source.
/// A full queue keeps the newest records. Additional records report how many records were
/// suppressed or lost.
///
/// Thread-safe. A thread waits for another thread at most for the time in which one record is
/// added or the records of one Take() are moved.
class LogQueue {
 public:
  static constexpr std::size_t kCapacity = 1024;
  /// Longer texts are cut to this many bytes, and end with "...".
  static constexpr std::size_t kLongestText = 1024;

  explicit LogQueue(const Clock& clock = SteadyClock()) : clock_(clock) {}

  /// Adds a record. Returns true if has_news() was false before. Allocates.
  bool Add(LogLevel level, std::string_view source, std::string_view text);

  /// Removes and returns the oldest records: at most `most`, plus one record about lost records.
  /// Reports suppressed records that are due at `now`; pass SteadyTime::max() in the last call.
  std::vector<message::LogRecord> Take(std::size_t most, SteadyTime now);

  /// True if Take() will return records, now or within LogLimiter::kUntilReport. Wait-free.
  [[nodiscard]] bool has_news() const noexcept { return has_news_.Get(); }

 private:
  /// A record, and the number of logged records that are lost if this record is dropped.
  struct QueuedRecord {
    message::LogRecord record;
    std::uint64_t stands_for = 1;
  };
  void Push(QueuedRecord waiting);

  const Clock& clock_;
  std::mutex mutex_;
  LogLimiter limiter_;
  std::deque<QueuedRecord> records_;
  std::uint64_t lost_ = 0;  // lost records that were not reported yet
  Flag has_news_{false};
};

}  // namespace tendon
