#pragma once

#include <tendon/base/clock.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/middleware.h>
#include <tendon/middleware/parts/lane.h>

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

/// Bytes of a frame that travel in one part, which is a frame of type kPart: so many at most, and,
/// but for the last part of the frame, at least the least.
inline constexpr std::size_t kPartSize = kMaxPieceSize - FrameHeader::kSize;
inline constexpr std::size_t kLeastPartSize = (std::size_t{16} << 10U) - FrameHeader::kSize;

/// An answer that goes back with its question is sent whole where it is no larger than this, the
/// peer speaks this version, and the line is quick.
inline constexpr std::size_t kMaxReturned = kMaxFrameSize;
inline constexpr std::uint16_t kReturnsLargeAnswers = 8;

/// Sends large frames in parts, lane by lane in turn, never more than four parts ahead of the peer,
/// which tells how much it has taken (kPartsTaken). So whatever else is sent meanwhile waits behind
/// that much at most, and nobody waits for the link. Thread-safe.
///
/// Parts are the size of what the line carries in kPartTime, as far as that is known, and small at
/// first: each is a sign of life at both ends, and must not take longer than anybody may be silent.
class PartSender {
 public:
  static constexpr std::size_t kPartsAhead = 4;
  static constexpr std::chrono::milliseconds kPartTime{250};
  /// For so long what a probe has told is believed of what goes past the parts.
  static constexpr std::chrono::milliseconds kQuickFor{1000};

  /// `clock` lives as long as this.
  explicit PartSender(const Clock& clock = SteadyClock()) : clock_(clock) {}

  /// Whether a frame of `size` bytes must be left to Add(): it is more than a part, or behind such
  /// a one of its lane. The other frames go to the link as they are.
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
  /// Bytes of the next part, unless it is the last of its frame.
  [[nodiscard]] std::size_t part_size() const { return part_size_.Get(); }
  /// Whether the line was just found to carry kMaxReturned in the time of a part.
  [[nodiscard]] bool is_quick() const { return clock_.Now() < quick_until_.Get(); }

 private:
  /// A frame behind the room for one more header: each part is sent from where it lies, its header
  /// written over the end of what was sent before.
  struct Frame {
    std::uint32_t number = 0;
    std::uint16_t version = 0;
    Bytes bytes;
    std::size_t sent = 0;

    void Write(const FrameHeader& header, std::span<const std::byte> body);
    [[nodiscard]] std::size_t size() const { return bytes.size() - FrameHeader::kSize; }
  };
  /// A frame that is sent: once the peer has taken what was sent up to its end, it counts no more.
  struct Sent {
    std::uint64_t end = 0;
    std::size_t size = 0;
  };

  /// One part, and what the peer had not taken when it was sent, the part included: once that is
  /// taken, it is known how much the line carries.
  struct Probe {
    std::uint64_t end = 0;
    std::size_t bytes = 0;
    SteadyTime since{};
  };

  [[nodiscard]] static bool IsHuge(std::size_t size) { return size > kSendWindow; }
  Status Reserve(std::size_t size);
  void Enter(Lane lane, Frame frame);
  void Release(std::size_t size);
  void Judge();
  void SendParts(Link& link);
  Status SendPart(Link& link, Frame& frame);

  const Clock& clock_;
  Flag is_busy_;  // whether there are lanes_
  Published<std::size_t> part_size_{kLeastPartSize};
  Published<SteadyTime> quick_until_;
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
  std::optional<Probe> probe_;
};

}  // namespace tendon
