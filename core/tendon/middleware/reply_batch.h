#pragma once

#include <tendon/middleware/frame.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace tendon {

/// The body of a frame that replies to several requests (MessageType::kReplies), to save messages.
/// Each reply consists of u64 request, u32 size and the bytes; little-endian, without padding. The
/// size of the body is limited, because it limits the work of the reader. Not thread-safe.
class ReplyBatch {
 public:
  static constexpr std::size_t kMaxReplies = 256;
  /// The largest size of the body. With its header, it always fits into one frame.
  static constexpr std::size_t kMaxBytes = (std::size_t{16} << 10U) - FrameHeader::kSize;
  /// The bytes that each reply needs in addition to its own bytes.
  static constexpr std::size_t kOverhead = 12;

  /// Appends a reply. Returns false and changes nothing if there is no room. A reply of more
  /// than kMaxBytes - kOverhead bytes never fits.
  bool Add(std::uint64_t request, std::span<const std::byte> reply);
  /// Removes all replies, but keeps the capacity.
  void Clear();

  [[nodiscard]] std::size_t replies() const { return replies_; }
  [[nodiscard]] const Bytes& body() const { return body_; }

 private:
  std::size_t replies_ = 0;
  Bytes body_;
};

/// One reply of a batch.
struct BatchedReply {
  std::uint64_t request = 0;
  std::span<const std::byte> body;
};

/// Removes the first reply from `body`, which is untrusted, and returns the reply. Returns no
/// value if the reply is incomplete.
std::optional<BatchedReply> TakeReply(std::span<const std::byte>& body);

/// Returns true if `body`, which is untrusted, is a valid batch: it has at least one reply, is
/// within the limits, and has no further bytes at the end.
[[nodiscard]] bool IsReplyBatch(std::span<const std::byte> body);

class Channel;

/// While this object exists, it collects the replies that this thread sends on kOwnLane, and sends
/// many of them in one message, in order. The message is sent when it is full, before a reply to
/// another peer, or when this object is destroyed. A single reply is sent without a batch.
///
/// Used by loops that find several ended calls. The object must not outlive the loop, because no
/// timer sends the replies. A thread may have only one object at a time.
class ReplyBatcher {
 public:
  ReplyBatcher();
  ReplyBatcher(const ReplyBatcher&) = delete;
  ReplyBatcher& operator=(const ReplyBatcher&) = delete;
  /// Sends the remaining replies.
  ~ReplyBatcher();

  /// Keeps a reply if this thread has a ReplyBatcher. If not, returns false, and the caller must
  /// send the reply itself.
  static bool Keep(Channel& channel, std::uint64_t request, std::span<const std::byte> reply);

 private:
  void Send();

  std::shared_ptr<Channel> channel_;  // the channel of the replies in batch_
  ReplyBatch& batch_;
};

}  // namespace tendon
