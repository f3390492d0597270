#pragma once

#include <tendon/middleware/frame.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace tendon {

/// Answers to several requests in the body of one frame (MessageType::kReplies), to save messages.
/// For each answer: u64 request, u32 size, the bytes; little-endian, without padding. Limited in
/// size, so that readers are limited as well. Not thread-safe.
class ReplyBatch {
 public:
  static constexpr std::size_t kMostReplies = 256;
  /// The largest body; with its header it always fits into one piece.
  static constexpr std::size_t kMostBytes = (std::size_t{16} << 10U) - FrameHeader::kSize;
  /// Bytes of an answer in addition to its body.
  static constexpr std::size_t kOverhead = 12;

  /// Appends an answer. Returns false without an effect if there is no room, which is always so
  /// above kMostBytes - kOverhead.
  bool Add(std::uint64_t request, std::span<const std::byte> answer);
  /// Keeps the capacity.
  void Clear();

  [[nodiscard]] std::size_t replies() const { return replies_; }
  [[nodiscard]] const Bytes& body() const { return body_; }

 private:
  std::size_t replies_ = 0;
  Bytes body_;
};

/// One answer of a batch.
struct BatchedReply {
  std::uint64_t request = 0;
  std::span<const std::byte> answer;
};

/// Removes the first answer from `body`, which is untrusted, and returns it. Returns no value if it
/// is incomplete.
std::optional<BatchedReply> TakeReply(std::span<const std::byte>& body);

/// True if untrusted bytes are the body of a batch: at least one answer, within the limits, and no
/// bytes left over.
[[nodiscard]] bool IsReplyBatch(std::span<const std::byte> body);

class Channel;

/// While this object exists, collects the replies that this thread gives in kOwnLane, and sends
/// them in order, many in one message: when it is destroyed, when a message is full, or before a
/// reply to another peer. A single reply is sent without a batch. For loops that find several ended
/// calls; it must not outlive the loop, because no timer sends the replies. One object at a time in
/// a thread.
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
