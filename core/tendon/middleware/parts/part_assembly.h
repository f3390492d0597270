#pragma once

#include <tendon/base/clock.h>
#include <tendon/lockfree/budget.h>
#include <tendon/middleware/frame.h>
#include <tendon/middleware/parts/large_in_hand.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <utility>

namespace tendon {

/// Puts together what a peer sends in parts (parts/part_sender.h). A peer has so much on its way at
/// a time as a PartSender lets it, and no more is kept for it: whoever claims more sends nonsense.
/// Memory is taken for what has come, not for what is claimed. Not thread-safe.
class PartAssembly {
 public:
  /// Asked of the header of a frame that is not whole with its first part: nothing is kept of what
  /// is not wanted, and nobody hears of it.
  using IsWanted = std::function<bool(const FrameHeader&)>;

  /// Bytes that all links of a process together keep of messages that are not whole, answers aside:
  /// 512 MiB.
  [[nodiscard]] static Budget<>& BudgetOfProcess();

  /// `budget` and `clock` live as long as this.
  explicit PartAssembly(IsWanted is_wanted = nullptr, Budget<>& budget = BudgetOfProcess(),
                        const Clock& clock = SteadyClock())
      : is_wanted_(std::move(is_wanted)), budget_(budget), clock_(clock) {}
  PartAssembly(const PartAssembly&) = delete;
  PartAssembly& operator=(const PartAssembly&) = delete;
  ~PartAssembly() { Clear(); }

  /// What a part has led to; the link is to be closed for nonsense, and where memory is out.
  enum class Progress {
    kMoreToCome,
    kWhole,        ///< a frame is whole
    kNonsense,     ///< no part of a frame that the peer may send
    kOutOfMemory,  ///< there is none for the frame
    kTooMuch       ///< the budget has no more: nothing of the frame is kept
  };
  /// What has been put together; it belongs to who has asked.
  struct Frame {
    FrameHeader header;
    Bytes body;
  };
  /// `number` tells the frames apart that come at one time; `frame` is set where one is whole, and
  /// its header where there is no room.
  Progress Add(std::uint32_t number, std::span<const std::byte> part, Frame& frame);

  /// A sender may handle something large for LargeInHand::kAtMost before it sends the next part,
  /// and takes its frames in turn, a part of each in PartSender::kPartTime.
  static constexpr std::chrono::seconds kPatience = LargeInHand::kAtMost + std::chrono::seconds(10);
  /// When the frame that waits longest for its next part has waited too long; never without one.
  [[nodiscard]] SteadyTime given_up() const;

  /// Bytes that have come since the link stands.
  [[nodiscard]] std::uint64_t taken() const { return taken_; }
  /// Bytes of the frames that have begun, whole as they will be.
  [[nodiscard]] std::size_t claimed() const { return claimed_.of_huge + claimed_.of_others; }
  /// Frees what has begun, and will not be whole.
  void Clear();

 private:
  struct Begun {
    FrameHeader header;
    Bytes body;
    std::size_t come = 0;  // of the body
    std::size_t kept = 0;  // of the budget
    bool is_wanted = true;
    SteadyTime last_part{};
  };
  struct Claims {
    std::size_t of_huge = 0;
    std::size_t of_others = 0;
  };
  using Frames = std::map<std::uint32_t, Begun>;

  [[nodiscard]] std::size_t& ClaimsFor(std::size_t size);
  Frames::iterator Begin(std::uint32_t number, std::span<const std::byte> part);
  Progress Keep(Begun& begun, std::span<const std::byte> more, bool is_last);
  void GiveBack(Begun& begun);

  const IsWanted is_wanted_;
  Budget<>& budget_;
  const Clock& clock_;
  Frames begun_;
  Claims claimed_;
  std::size_t kept_ = 0;  // of the budget
  std::uint64_t taken_ = 0;
};

}  // namespace tendon
