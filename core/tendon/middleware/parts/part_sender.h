#pragma once

#include <tendon/lockfree/flag.h>
#include <tendon/middleware/middleware.h>
#include <tendon/middleware/parts/lane.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <span>
#include <utility>

namespace tendon {

/// A frame of at most this many bytes is sent in one piece. What is behind it waits for so much.
inline constexpr std::size_t kMaxPieceSize = std::size_t{256} << 10U;
/// Bytes of a frame that travel in one part, which is a frame of type kPart: every part of it but
/// the last has so many, and no frame is larger than kMaxPieceSize.
inline constexpr std::size_t kPartSize = kMaxPieceSize - FrameHeader::kSize;

/// Sends frames over kMaxPieceSize in parts, lane by lane in turn, never more ahead of the peer
/// than kPartsAhead, which tells how much it has taken (kPartsTaken). So whatever else is sent
/// meanwhile waits behind that much at most, and nobody waits for the link. Thread-safe.
class PartSender {
 public:
  static constexpr std::size_t kPartsAhead = std::size_t{1} << 20U;  ///< bytes

  /// Whether a frame of `size` bytes must be left to Add(): it is large, or behind a large one of
  /// its lane. The other frames go to the link as they are.
  [[nodiscard]] bool MustTake(Lane lane, std::size_t size);

  /// Takes a copy. Refusals as of Link::Send(), whose window all frames share that are here, but
  /// for one alone that may be larger; kQueueFull makes a large one wait for large ones only.
  Status Add(Link& link, Lane lane, const FrameHeader& header, std::span<const std::byte> body);

  /// The peer has taken so many bytes since the link stands; false where it cannot have.
  bool OnTaken(Link& link, std::uint64_t bytes);
  /// Goes on where the link had no room. To be called whenever something is sent or arrives, and
  /// now and then: a link without room drains without a word.
  void Resume(Link& link);

  /// Frees all, and takes nothing more: the link has ended.
  void Close();

  /// Bytes that are here, or on their way.
  [[nodiscard]] std::size_t waiting() const;

 private:
  struct Frame {
    std::uint32_t number = 0;
    Bytes bytes;
    std::size_t sent = 0;
  };
  /// A frame that is sent: once the peer has taken what was sent up to its end, it counts no more.
  struct Sent {
    std::uint64_t end = 0;
    std::size_t size = 0;
  };

  [[nodiscard]] static bool IsHuge(std::size_t size) { return size > kSendWindow; }
  Status Reserve(std::size_t size);
  void Enter(Lane lane, Frame frame);
  void Release(std::size_t size);
  void SendParts(Link& link);
  Status SendPart(Link& link, Frame& frame);

  Flag is_busy_;  // whether there are lanes_
  mutable std::mutex mutex_;
  bool is_closed_ = false;
  std::uint32_t last_number_ = 0;
  Lane last_lane_ = kCommonLane;
  std::map<Lane, std::deque<Frame>> lanes_;
  std::deque<Sent> on_way_;
  std::size_t waiting_ = 0;       // bytes of what is no larger than the window
  std::size_t huge_waiting_ = 0;  // of the one that is
  std::uint64_t sent_ = 0;        // bytes, since the link stands
  std::uint64_t taken_ = 0;
  Bytes part_;
};

}  // namespace tendon
