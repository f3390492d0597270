#pragma once

#include <tendon/middleware/requests/reply_batch.h>

#include <cstdint>
#include <memory>
#include <span>

namespace tendon {

class Channel;

/// While it lives, the answers that this thread gives, each in a lane of its own, are kept, in
/// order, and sent many in a message: when it ends, when a message is full, or when an answer to
/// another peer comes. One answer alone is sent as ever. Nobody waits for a clock: it is for where
/// several calls are found to have ended, and lives no longer than it takes to say so. One at a
/// time in a thread.
class GatheredReplies {
 public:
  GatheredReplies();
  GatheredReplies(const GatheredReplies&) = delete;
  GatheredReplies& operator=(const GatheredReplies&) = delete;
  /// Sends what is left.
  ~GatheredReplies();

  /// Keeps an answer, where one of these lives in this thread; false where it must be sent.
  static bool Keep(Channel& channel, std::uint64_t request, std::span<const std::byte> answer);

 private:
  void Send();

  std::shared_ptr<Channel> channel_;  // whose answers are in the batch
  ReplyBatch& batch_;
};

}  // namespace tendon
