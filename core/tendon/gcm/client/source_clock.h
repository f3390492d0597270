#pragma once

#include <tendon/gcm/event_sink.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/clock_offset.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace tendon::client {

/// Measures the offset between the steady clock of the process at the other end of a channel and
/// the steady clock of this process. Measures twice a second while the channel is open and this
/// object exists. Thread-safe.
class SourceClock final : public std::enable_shared_from_this<SourceClock> {
 public:
  using Handler = std::function<void(const Result<std::shared_ptr<SourceClock>>&)>;

  /// The thread of `timer` must never block. A measurement fails if there is no reply within
  /// `timeout`.
  SourceClock(std::shared_ptr<Worker> timer, std::shared_ptr<Channel> channel,
              std::chrono::milliseconds timeout);

  /// Calls `known` once: with this object when the offset is known, or with an error. Calls it at
  /// once, or later in a thread of the middleware or the timer.
  void WhenKnown(Handler known);

  /// Converts the time of an event from the other process's clock to the clock of this process.
  [[nodiscard]] EventTime ToLocal(SteadyTime there) const;

 private:
  void Ask();
  void AskLater();

  const std::shared_ptr<Worker> timer_;
  const std::shared_ptr<Channel> channel_;
  const std::chrono::milliseconds timeout_;
  mutable std::mutex mutex_;  // guards the members below
  ClockOffset offset_;
  bool is_known_ = false;
  std::vector<Handler> waiting_;
};

}  // namespace tendon::client
