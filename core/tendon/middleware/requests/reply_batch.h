#pragma once

#include <tendon/middleware/frame.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace tendon {

/// Answers to several requests in the body of one frame (MessageType::kReplies), so that what has
/// ended together costs one message: for each u64 request, u32 size, so many bytes, little-endian,
/// without padding. Bounded, for who reads it too. Not thread-safe.
class ReplyBatch {
 public:
  static constexpr std::size_t kMostReplies = 256;
  /// Of the body: with its header it is never sent in parts.
  static constexpr std::size_t kMostBytes = (std::size_t{16} << 10U) - FrameHeader::kSize;
  /// Bytes that an answer takes beside its own.
  static constexpr std::size_t kOverhead = 12;

  /// Behind the others. False, and nothing happens, where there is no room; for an answer of more
  /// than kMostBytes - kOverhead there never is.
  bool Add(std::uint64_t request, std::span<const std::byte> answer);
  /// Keeps the capacity.
  void Clear();

  [[nodiscard]] std::size_t replies() const { return replies_; }
  [[nodiscard]] const Bytes& body() const { return body_; }

 private:
  std::size_t replies_ = 0;
  Bytes body_;
};

/// What a request is answered with.
struct OneReply {
  std::uint64_t request = 0;
  std::span<const std::byte> answer;
};

/// Takes the first answer off; nothing where `body`, of any origin, begins with no whole one.
std::optional<OneReply> TakeReply(std::span<const std::byte>& body);

/// Whether bytes of any origin are the body of a batch: one answer at least, within the bounds, and
/// whole to the last byte.
[[nodiscard]] bool IsReplyBatch(std::span<const std::byte> body);

}  // namespace tendon
