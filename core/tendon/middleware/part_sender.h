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

/// Messages of one lane of a channel arrive in the order in which they were sent. No message waits
/// for a large message of another lane. The numbers come from Channel::NewLane(), are valid at one
/// end of one channel, and are not sent.
using Lane = std::uint64_t;

/// The default lane.
inline constexpr Lane kCommonLane = 0;
/// A separate lane for one message: it has no order relative to other messages.
inline constexpr Lane kOwnLane = ~Lane{0};

/// The largest size of a part, which is a frame of type kPart; and the smallest size of all parts
/// of a frame except the last.
inline constexpr std::size_t kPartSize = kMaxPieceSize - FrameHeader::kSize;
inline constexpr std::size_t kLeastPartSize = (std::size_t{16} << 10U) - FrameHeader::kSize;

/// The largest reply that may be sent whole, as the response to its request. A reply that is larger
/// than a part is sent whole only if the link is fast.
inline constexpr std::size_t kMaxReturned = kMaxFrameSize;

/// Sends large frames in parts, one part of each lane in turn. At most four parts are sent that the
/// peer has not acknowledged (kPartsTaken). So other messages wait behind at most four parts, and
/// no caller waits for the link. Thread-safe.
///
/// Parts are small at first, and then as large as the link can transmit in kPartTime. Each part is
/// a sign of life for both ends, so it must not take longer than a peer may be silent.
class PartSender {
 public:
  static constexpr std::size_t kPartsAhead = 4;
  static constexpr std::chrono::milliseconds kPartTime{250};
  /// How long a speed measured by a probe is valid.
  static constexpr std::chrono::milliseconds kQuickFor{1000};

  /// `clock` must outlive this object.
  explicit PartSender(const Clock& clock = SteadyClock()) : clock_(clock) {}

  /// Returns true if a frame of `size` bytes must go to Add(): it is larger than a part, or another
  /// frame of its lane is waiting here. All other frames go to the link directly.
  [[nodiscard]] bool MustSendInParts(Lane lane, std::size_t size);

  /// Copies the frame. Fails as Link::Send() does. Waiting frames share kSendWindow, except one
  /// larger frame at a time. A large frame gets kQueueFull only because of other large frames.
  Status Add(Link& link, Lane lane, const FrameHeader& header, std::span<const std::byte> body);

  /// The peer reports that it has received `bytes` in total since the link was opened. Returns
  /// false if that is impossible.
  bool OnTaken(Link& link, std::uint64_t bytes);
  /// Continues after the link was full. Call it after each send and arrival, and regularly, because
  /// a link does not report that it has room again.
  void Resume(Link& link);

  /// Frees all frames and accepts no more: the link has ended.
  void Close();

  /// Bytes that wait here, or are sent and not yet acknowledged.
  [[nodiscard]] std::size_t waiting() const;
  /// Bytes of the next part, unless it is the last of its frame.
  [[nodiscard]] std::size_t part_size() const { return part_size_.Get(); }
  /// True if the link has recently transmitted kMaxReturned bytes within kPartTime.
  [[nodiscard]] bool is_quick() const { return clock_.Now() < quick_until_.Get(); }

 private:
  /// A frame, with room for one more header in front. Each part is sent without a copy; its header
  /// overwrites the end of the part before.
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

  /// Measures the speed of the link with one part. `bytes` is the number of bytes that are not
  /// acknowledged when the part is sent, including the part. The time until all of them are
  /// acknowledged gives the speed.
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
  Flag is_busy_;  // set while there are lanes_
  Published<std::size_t> part_size_{kLeastPartSize};
  Published<SteadyTime> quick_until_;
  mutable std::mutex mutex_;
  bool is_closed_ = false;
  std::uint32_t last_number_ = 0;
  Lane last_lane_ = kCommonLane;
  std::map<Lane, std::deque<Frame>> lanes_;
  std::deque<SentFrame> on_way_;
  std::size_t waiting_ = 0;       // bytes of frames that are not larger than the window
  std::size_t huge_waiting_ = 0;  // bytes of the one larger frame
  std::uint64_t sent_ = 0;        // bytes since the link was opened
  std::uint64_t taken_ = 0;
  std::optional<Probe> probe_;
};

}  // namespace tendon
