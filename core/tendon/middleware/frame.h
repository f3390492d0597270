#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tendon {

using Bytes = std::vector<std::byte>;

/// The type of a frame. The numbers are part of the protocol. Each layer has its own range.
enum class MessageType : std::uint16_t {
  kHello = 1,
  kWelcome = 2,
  kReply = 3,    ///< replies to a request; the body is the reply
  kRefusal = 4,  ///< refuses a request; the body is an Error
  kChallenge = 5,
  kProof = 6,
  kPart = 7,  ///< next bytes of a frame that is too large for one piece; `handle` is the number of
              ///< the frame
  kPartsTaken = 8,  ///< u64: total bytes of parts received since the link was opened
  kReplies = 9,     ///< replies to several requests; the body is a ReplyBatch
  // The layers above define their types in the files *_messages.h of their folders. proxy uses
  // numbers from 0x100 on, process from 0x200 on, gcm from 0x300 on.
};

/// The header before every body: 24 bytes, little-endian, in this order, without padding.
struct FrameHeader {
  std::uint32_t magic = kMagic;
  std::uint16_t version = kProtocolVersion;
  MessageType type = MessageType::kHello;
  std::uint64_t request = 0;  ///< 0: no reply is expected
  std::uint32_t size = 0;     ///< bytes of the body
  /// The addressee in the receiver's process. The receiver has issued this number and checks it.
  std::uint32_t handle = 0;

  static constexpr std::uint32_t kMagic = 0x4e444e54;  // "TNDN"
  /// Must be increased when a message or its meaning changes. Both ends of a link must use the same
  /// version, because bodies do not contain the names of their fields.
  static constexpr std::uint16_t kProtocolVersion = 11;
  static constexpr std::size_t kSize = 24;
};

/// The largest size of a frame, including the header. Only the direct response to a request with
/// Delivery::kDirect may be this large. The limit can be higher here, because this program has
/// chosen the peer and has requested the response.
inline constexpr std::size_t kMaxFrameSize = (std::size_t{1} << 20U) + (std::size_t{64} << 10U);
/// The largest size of all other frames. It is smaller, because any peer can make this process
/// store such a frame. Larger messages are sent in parts.
inline constexpr std::size_t kMaxPieceSize = std::size_t{256} << 10U;
/// The largest size of a frame from a peer that is not authenticated yet.
inline constexpr std::size_t kMaxUnauthenticatedFrameSize = std::size_t{64} << 10U;

/// Writes header and body to `frame`. Replaces its content and keeps its capacity.
void WriteFrame(const FrameHeader& header, std::span<const std::byte> body, Bytes& frame);

/// Writes only the header, in front of a body that is already there.
void WriteHeader(const FrameHeader& header, std::span<std::byte, FrameHeader::kSize> place);

/// Reads the header at the beginning of `bytes`. Returns nothing if there are too few bytes, if the
/// magic number is wrong, or if the frame would be larger than `limit`. Does not check the version.
[[nodiscard]] std::optional<FrameHeader> ReadFrameHeader(std::span<const std::byte> bytes,
                                                         std::size_t limit = kMaxFrameSize);

/// Like ReadFrameHeader(), but also returns nothing if the size of `frame` is not the size that its
/// header gives.
[[nodiscard]] std::optional<FrameHeader> ReadWholeFrame(std::span<const std::byte> frame,
                                                        std::size_t limit = kMaxFrameSize);

}  // namespace tendon
