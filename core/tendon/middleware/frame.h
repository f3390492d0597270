#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tendon {

using Bytes = std::vector<std::byte>;

/// What a frame means; the numbers are the protocol. Each layer keeps its own range.
enum class MessageType : std::uint16_t {
  kHello = 1,
  kWelcome = 2,
  kReply = 3,    ///< answers a request: its body is the answer
  kRefusal = 4,  ///< answers a request: its body is an Error
  kChallenge = 5,
  kProof = 6,
  kPart = 7,        ///< the next bytes of a frame too large for one piece; `handle` tells which
  kPartsTaken = 8,  ///< u64: bytes of parts that have been taken since the link stands
  kReplies = 9,     ///< answers several requests: a ReplyBatch
  // Those of the layers above have the messages.h of their folders: proxy from 0x100 on, process
  // from 0x200, gcm from 0x300.
};

/// The fixed 24 bytes before every body, little-endian, in this order, without padding.
struct FrameHeader {
  std::uint32_t magic = kMagic;
  std::uint16_t version = kProtocolVersion;
  MessageType type = MessageType::kHello;
  std::uint64_t request = 0;  ///< 0: no answer is wanted
  std::uint32_t size = 0;     ///< bytes of the body
  std::uint32_t handle = 0;   ///< what it is for: issued by the receiver, checked on arrival

  static constexpr std::uint32_t kMagic = 0x4e444e54;  // "TNDN"
  /// Raised when a message or what it means changes: a body says nothing of the fields it has.
  static constexpr std::uint16_t kProtocolVersion = 9;
  /// The oldest one that is spoken too; what newer ones add is kept from a peer that has it not.
  static constexpr std::uint16_t kOldestVersion = 9;
  static constexpr std::size_t kSize = 24;
};

/// A frame may have at most this many bytes, header included, as an answer that goes back with its
/// question: whom we ask we have chosen.
inline constexpr std::size_t kMaxFrameSize = (std::size_t{1} << 20U) + (std::size_t{64} << 10U);
/// The same of one that is sent, which anybody can make us hold. What is larger travels in parts.
inline constexpr std::size_t kMaxPieceSize = std::size_t{256} << 10U;
/// The same of a peer that is not known yet.
inline constexpr std::size_t kMaxStrangersFrameSize = std::size_t{64} << 10U;

/// Header and body in one piece of memory; replaces the content of `frame`, keeps its capacity.
void WriteFrame(const FrameHeader& header, std::span<const std::byte> body, Bytes& frame);

/// The header alone, to where a frame begins that lies in memory already.
void WriteHeader(const FrameHeader& header, std::span<std::byte, FrameHeader::kSize> place);

/// Reads the header at the front of `bytes`; nothing where they are too few, begin with another
/// magic number or claim a frame of over `limit` bytes. Says nothing of the version.
[[nodiscard]] std::optional<FrameHeader> ReadFrameHeader(std::span<const std::byte> bytes,
                                                         std::size_t limit = kMaxFrameSize);

/// The same for exactly one frame: nothing where it has another size than its header claims.
[[nodiscard]] std::optional<FrameHeader> ReadWholeFrame(std::span<const std::byte> frame,
                                                        std::size_t limit = kMaxFrameSize);

}  // namespace tendon
