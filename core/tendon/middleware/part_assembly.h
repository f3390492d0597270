#pragma once

#include <tendon/base/clock.h>
#include <tendon/lockfree/budget.h>
#include <tendon/middleware/frame.h>
#include <tendon/middleware/large_message_in_progress.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <utility>

namespace tendon {

/// Assembles the frames that a peer sends in parts (part_sender.h). A peer may begin only as many
/// unfinished bytes as a PartSender sends; more bytes violate the protocol. Memory is allocated for
/// bytes that have arrived, not for the size that the peer has announced. Not thread-safe.
class PartAssembly {
 public:
  /// Called with the header of a frame that needs more than one part. If it returns false, the
  /// frame is discarded silently.
  using IsWanted = std::function<bool(const FrameHeader&)>;

  /// The budget that all links of the process share: at most 512 MiB of unfinished messages, not
  /// counting replies.
  [[nodiscard]] static Budget<>& BudgetOfProcess();

  /// `budget` and `clock` must outlive this object.
  explicit PartAssembly(IsWanted is_wanted = nullptr, Budget<>& budget = BudgetOfProcess(),
                        const Clock& clock = SteadyClock())
      : is_wanted_(std::move(is_wanted)), budget_(budget), clock_(clock) {}
  PartAssembly(const PartAssembly&) = delete;
  PartAssembly& operator=(const PartAssembly&) = delete;
  ~PartAssembly() { Clear(); }

  /// The result of adding a part. After kMalformed and kOutOfMemory, the caller must close the
  /// link.
  enum class Progress {
    kMoreToCome,
    kWhole,        ///< a frame is complete
    kMalformed,    ///< the peer must not send this part
    kOutOfMemory,  ///< no memory for the frame
    kTooMuch       ///< the budget is used up: the frame is discarded
  };
  /// An assembled frame; the caller owns it.
  struct Frame {
    FrameHeader header;
    Bytes body;
  };
  /// Adds a part to the unfinished frame with this number. Sets `frame` if the frame is complete.
  /// With kTooMuch, sets only its header.
  Progress Add(std::uint32_t number, std::span<const std::byte> part, Frame& frame);

  /// The time to wait for the next part of a frame. The sender may first handle a large message for
  /// up to LargeMessageInProgress::kAtMost. After that, it sends one part of each of its frames in
  /// turn, each part within PartSender::kPartTime.
  static constexpr std::chrono::seconds kPartTimeout =
      LargeMessageInProgress::kAtMost + std::chrono::seconds(10);
  /// The time at which the oldest unfinished frame times out; max() if there is no unfinished
  /// frame.
  [[nodiscard]] SteadyTime given_up() const;

  /// Bytes of parts that have arrived since the link was opened.
  [[nodiscard]] std::uint64_t taken() const { return taken_; }
  /// Bytes of the unfinished frames, counted at their full size.
  [[nodiscard]] std::size_t claimed() const { return claimed_.of_huge + claimed_.of_others; }
  /// Frees the unfinished frames.
  void Clear();

 private:
  struct UnfinishedFrame {
    FrameHeader header;
    Bytes body;
    std::size_t come = 0;  // bytes of the body that have arrived
    std::size_t kept = 0;  // bytes taken from the budget
    bool is_wanted = true;
    SteadyTime last_part{};
  };
  struct Claims {
    std::size_t of_huge = 0;
    std::size_t of_others = 0;
  };
  using Frames = std::map<std::uint32_t, UnfinishedFrame>;

  [[nodiscard]] std::size_t& ClaimsFor(std::size_t size);
  Frames::iterator Begin(std::uint32_t number, std::span<const std::byte> part);
  Progress Keep(UnfinishedFrame& unfinished, std::span<const std::byte> more, bool is_last);
  void ReleaseBudget(UnfinishedFrame& unfinished);

  const IsWanted is_wanted_;
  Budget<>& budget_;
  const Clock& clock_;
  Frames unfinished_;
  Claims claimed_;
  std::size_t kept_ = 0;  // bytes taken from the budget
  std::uint64_t taken_ = 0;
};

}  // namespace tendon
