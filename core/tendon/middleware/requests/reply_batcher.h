#pragma once

#include <tendon/middleware/requests/reply_batch.h>

#include <cstdint>
#include <memory>
#include <span>

namespace tendon {

class Channel;

/// While it lives, collects the replies that this thread gives in kOwnLane, and sends them in
/// order, many in one message: when it is destroyed, when a message is full, or before a reply to
/// another peer. A single reply is sent without a batch. For loops that find several ended calls;
/// it must not outlive the loop, because no timer sends the replies. One object at a time in a
/// thread.
class ReplyBatcher {
 public:
  ReplyBatcher();
  ReplyBatcher(const ReplyBatcher&) = delete;
  ReplyBatcher& operator=(const ReplyBatcher&) = delete;
  /// Sends the remaining replies.
  ~ReplyBatcher();

  /// Keeps an answer if this thread has a ReplyBatcher; returns false if it must be sent.
  static bool Keep(Channel& channel, std::uint64_t request, std::span<const std::byte> answer);

 private:
  void Send();

  std::shared_ptr<Channel> channel_;  // the channel of the replies in batch_
  ReplyBatch& batch_;
};

}  // namespace tendon
