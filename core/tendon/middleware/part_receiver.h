#pragma once

#include <tendon/base/clock.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/large_message_in_progress.h>
#include <tendon/middleware/part_assembly.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <utility>

namespace tendon {

/// The receiving counterpart of PartSender: joins the parts of the peer's large messages, and
/// reports to the peer how many bytes have arrived.
///
/// Thread safety: Add() and Clear() may be called only in the middleware's thread, all other
/// functions in any thread.
class PartReceiver {
 public:
  explicit PartReceiver(PartAssembly::IsWanted is_wanted) : assembly_(std::move(is_wanted)) {}

  /// Like PartAssembly::Add().
  PartAssembly::Progress Add(std::uint32_t number, std::span<const std::byte> part,
                             PartAssembly::Frame& frame) {
    const PartAssembly::Progress progress = assembly_.Add(number, part, frame);
    taken_.Set(assembly_.taken());
    given_up_.Set(assembly_.given_up());
    return progress;
  }
  /// Frees the unfinished messages.
  void Clear() {
    assembly_.Clear();
    given_up_.Set(assembly_.given_up());
  }

  /// True if bytes have arrived that were not reported yet.
  [[nodiscard]] bool has_news() const { return taken_.Get() != reported_taken_.Get(); }
  /// Calls `send(bytes) -> Status` with the number of bytes that have arrived since the link was
  /// opened. Only one report is sent at a time, so that the numbers arrive in order.
  template <typename Send>
  void Report(Send send) {
    const std::scoped_lock lock(reporting_);
    const std::uint64_t taken = taken_.Get();
    if (send(taken)) reported_taken_.Set(taken);
  }

  /// Returns true if the peer has stopped in the middle of a message. Pauses are allowed: the peer
  /// sends no parts while it handles a large message, and this end reads no parts while it handles
  /// a large message.
  [[nodiscard]] bool IsUnfinishedTooLong(SteadyTime now) const {
    return now >= std::max(given_up_.Get(),
                           LargeMessageInProgress::Last(now) + PartAssembly::kPartTimeout);
  }

 private:
  PartAssembly assembly_;              // used only in the middleware's thread
  Published<std::uint64_t> taken_{0};  // copy of assembly_.taken()
  Published<std::uint64_t> reported_taken_{0};
  Published<SteadyTime> given_up_{SteadyTime::max()};  // copy of assembly_.given_up()
  std::mutex reporting_;
};

}  // namespace tendon
