#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tendon {

using Bytes = std::vector<std::byte>;

/// The meaning of a frame. The numbers are part of the protocol. Each layer has its own range.
enum class MessageType : std::uint16_t {
  kHello = 1,
  kWelcome = 2,
  kReply = 3,    ///< answers a request: its body is the answer
  kRefusal = 4,  ///< answers a request: its body is an Error
  kChallenge = 5,
  kProof = 6,
  kPart = 7,        ///< next bytes of a frame too large for one piece; `handle` numbers the frame
  kPartsTaken = 8,  ///< u64: bytes of parts received since the link was opened
  kReplies = 9,     ///< answers several requests: a ReplyBatch
  // The layers above define their types in *_messages.h of their folders: proxy from 0x100 on,
  // process from 0x200, gcm from 0x300.
};

/// The fixed 24 bytes before every body, little-endian, in this order, without padding.
struct FrameHeader {
  std::uint32_t magic = kMagic;
  std::uint16_t version = kProtocolVersion;
  MessageType type = MessageType::kHello;
  std::uint64_t request = 0;  ///< 0: no answer is expected
  std::uint32_t size = 0;     ///< bytes of the body
  std::uint32_t handle = 0;   ///< the destination; issued by the receiver, which checks it

  static constexpr std::uint32_t kMagic = 0x4e444e54;  // "TNDN"
  /// Raise it when a message or its meaning changes: bodies do not name their fields. Both ends of
  /// a link must speak the same version.
  static constexpr std::uint16_t kProtocolVersion = 10;
  static constexpr std::size_t kSize = 24;
};

/// The largest frame, header included. Only a reply that is sent as the response to a request with
/// Delivery::kDirect may be this large, because this program has chosen the peer that it asks.
inline constexpr std::size_t kMaxFrameSize = (std::size_t{1} << 20U) + (std::size_t{64} << 10U);
/// The largest frame in all other cases, because any peer can make us store it. Larger messages are
/// sent in parts.
inline constexpr std::size_t kMaxPieceSize = std::size_t{256} << 10U;
/// The largest frame of a peer that is not authenticated yet.
inline constexpr std::size_t kMaxUnauthenticatedFrameSize = std::size_t{64} << 10U;

/// Writes header and body to `frame`, whose content is replaced and whose capacity is kept.
void WriteFrame(const FrameHeader& header, std::span<const std::byte> body, Bytes& frame);

/// Writes only the header, in front of a body that is already there.
void WriteHeader(const FrameHeader& header, std::span<std::byte, FrameHeader::kSize> place);

/// Reads the header at the front of `bytes`. Returns nothing if there are too few bytes, the magic
/// number is wrong, or the frame would exceed `limit` bytes. Does not check the version.
[[nodiscard]] std::optional<FrameHeader> ReadFrameHeader(std::span<const std::byte> bytes,
                                                         std::size_t limit = kMaxFrameSize);

/// The same, but returns nothing unless `frame` has exactly the size that its header claims.
[[nodiscard]] std::optional<FrameHeader> ReadWholeFrame(std::span<const std::byte> frame,
                                                        std::size_t limit = kMaxFrameSize);

}  // namespace tendon
