#pragma once

#include <tendon/gcm/client.h>
#include <tendon/gcm/messages.h>

#include <cstdint>
#include <mutex>

namespace tendon::client {

/// How far a viewer has come in the log of its GCM: goes on there after the link broke, begins anew
/// with another GCM, and sees what is missing. Thread-safe.
class LogFeed {
 public:
  /// What a new channel is asked for.
  [[nodiscard]] message::WatchLog Wanted() const;
  /// The answer to it.
  LogBatch Begin(const message::LogWatched& watched);
  /// The next records. Those that were heard before are taken out.
  LogBatch Take(message::LogRecords batch);

 private:
  mutable std::mutex mutex_;
  std::uint64_t gcm_instance_ = 0;
  std::uint64_t next_ = 0;     // number of the record that comes next
  std::uint64_t current_ = 0;  // from here on they are new
};

}  // namespace tendon::client
