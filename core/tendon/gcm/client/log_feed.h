#pragma once

#include <tendon/gcm/client.h>
#include <tendon/gcm/gcm_messages.h>

#include <cstdint>
#include <mutex>

namespace tendon::client {

/// Keeps a viewer's position in the log of its GCM, and detects gaps. The position stays valid when
/// the link is restored. With another GCM, the position begins again. Thread-safe.
class LogFeed {
 public:
  /// The request to send on a new channel.
  [[nodiscard]] message::WatchLog Wanted() const;
  /// Handles the reply to the request; returns an empty batch.
  LogBatch Begin(const message::WatchLogReply& watched);
  /// Returns the received records that were not delivered before.
  LogBatch Take(message::LogRecords batch);

 private:
  mutable std::mutex mutex_;
  std::uint64_t gcm_instance_ = 0;
  std::uint64_t next_ = 0;     // number of the next record
  std::uint64_t current_ = 0;  // records from this number on are newer than the request
};

}  // namespace tendon::client
