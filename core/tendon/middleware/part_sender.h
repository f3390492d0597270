#pragma once

#include <tendon/base/clock.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/middleware.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

namespace tendon {

/// The number of a lane of a channel. Messages on one lane arrive in the order in which they were
/// sent. A message never waits for a large message on another lane. The number comes from
/// Channel::NewLane(); it is valid only at one end of one channel, and is not sent to the peer.
using Lane = std::uint64_t;

/// The default lane.
inline constexpr Lane kCommonLane = 0;
/// A separate lane for one message. The message has no fixed order relative to others.
inline constexpr Lane kOwnLane = ~Lane{0};

/// The largest size of a part, which is the body of a frame of type kPart. The smallest size
/// applies to all parts of a frame except the last.
inline constexpr std::size_t kPartSize = kMaxPieceSize - FrameHeader::kSize;
inline constexpr std::size_t kMinPartSize = (std::size_t{16} << 10U) - FrameHeader::kSize;

/// The largest reply that may be sent whole, as the response to a direct request. A reply that is
/// larger than a part is sent whole only if the link is fast.
inline constexpr std::size_t kMaxReturned = kMaxFrameSize;

/// Sends large frames in parts, one part of each lane in turn. At most four parts may be sent and
/// not yet acknowledged by the peer (kPartsTaken), so another message waits for at most four parts.
/// No function blocks. Thread-safe.
///
/// Parts are small at first, and then as large as the link can transmit in kPartTime. Both ends use
/// each part as a sign of life, so a part must not take longer than a peer may be silent.
class PartSender {
 public:
  static constexpr std::size_t kPartsAhead = 4;
  static constexpr std::chrono::milliseconds kPartTime{250};
  /// The time for which a measurement of the link's speed is valid.
  static constexpr std::chrono::milliseconds kQuickFor{1000};

  /// `clock` must outlive this object.
  explicit PartSender(const Clock& clock = SteadyClock()) : clock_(clock) {}

  /// Returns true if a frame of `size` bytes must be sent with Add(), because it is larger than a
  /// part, or because another frame of its lane waits here. All other frames can be sent directly
  /// on the link.
  [[nodiscard]] bool MustSendInParts(Lane lane, std::size_t size);

  /// Copies the frame and begins to send it. Fails like Link::Send(). All waiting frames together
  /// may have kSendWindow bytes. In addition, one frame at a time may be larger than this window.
  /// Only the frames that wait here can cause kQueueFull.
  Status Add(Link& link, Lane lane, const FrameHeader& header, std::span<const std::byte> body);

  /// Called when the peer reports that it has received `bytes` in total since the link was opened.
  /// Returns false if this number is not possible.
  bool OnTaken(Link& link, std::uint64_t bytes);
  /// Continues to send if the link was full. Must be called after each sent or received frame, and
  /// regularly, because a link does not report when it has room again.
  void Resume(Link& link);

  /// Called when the link has ended. Frees all frames and accepts no more.
  void Close();

  /// Bytes of frames that wait here, or that were sent but not acknowledged yet.
  [[nodiscard]] std::size_t waiting() const;
  /// The size of the next part in bytes. The last part of a frame may be smaller.
  [[nodiscard]] std::size_t part_size() const { return part_size_.Get(); }
  /// True if the link has recently transmitted kMaxReturned bytes within kPartTime.
  [[nodiscard]] bool is_quick() const { return clock_.Now() < quick_until_.Get(); }

 private:
  /// A frame, with memory for one more header in front of it. Each part is sent without a copy: the
  /// header of a part overwrites the end of the previous part, which has already been sent.
  struct Frame {
    std::uint32_t number = 0;
    Bytes bytes;
    std::size_t sent = 0;

    void Write(const FrameHeader& header, std::span<const std::byte> body);
    [[nodiscard]] std::size_t size() const { return bytes.size() - FrameHeader::kSize; }
  };
  /// A frame that was sent completely. It counts as waiting until the peer has received all bytes
  /// up to `end`.
  struct SentFrame {
    std::uint64_t end = 0;
    std::size_t size = 0;
  };

  /// A measurement of the link's speed with one part. `bytes` is the number of unacknowledged bytes
  /// when the part is sent, including the part. The speed follows from the time until all of these
  /// bytes are acknowledged.
  struct Probe {
    std::uint64_t end = 0;
    std::size_t bytes = 0;
    SteadyTime since{};
  };

  [[nodiscard]] static bool IsHuge(std::size_t size) { return size > kSendWindow; }
  Status Reserve(std::size_t size);
  void Enter(Lane lane, Frame frame);
  void Release(std::size_t size);
  void UpdatePartSize();
  void SendParts(Link& link);
  Status SendPart(Link& link, Frame& frame);

  const Clock& clock_;
  Flag is_busy_;  // true while lanes_ is not empty
  Published<std::size_t> part_size_{kMinPartSize};
  Published<SteadyTime> quick_until_;
  mutable std::mutex mutex_;
  bool is_closed_ = false;
  std::uint32_t last_number_ = 0;
  Lane last_lane_ = kCommonLane;
  std::map<Lane, std::deque<Frame>> lanes_;
  std::deque<SentFrame> on_way_;
  std::size_t waiting_ = 0;       // bytes of frames that are not larger than the window
  std::size_t huge_waiting_ = 0;  // bytes of the frame that is larger than the window
  std::uint64_t sent_ = 0;        // bytes sent since the link was opened
  std::uint64_t taken_ = 0;
  std::optional<Probe> probe_;
};

}  // namespace tendon
