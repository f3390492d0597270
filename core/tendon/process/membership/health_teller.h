#pragma once

#include <tendon/base/clock.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/telemetry/clock_offset.h>

#include <memory>
#include <mutex>

namespace tendon {

/// Tells a GCM each second what this process takes of its machine, and measures the GCM's clock by
/// its answers. Of one thread, but for the answers.
class HealthTeller {
 public:
  /// Tells it if a second has passed, or the channel is another one than last time. Brings `next`
  /// forward to when it wants to be called again.
  void Tell(const std::shared_ptr<Channel>& channel, SteadyTime now, SteadyTime& next);

 private:
  struct GcmsClock {
    std::mutex mutex;
    ClockOffset offset;
  };

  void TellNow(Channel& channel);

  std::weak_ptr<Channel> channel_;
  std::shared_ptr<GcmsClock> clock_;  // shared with what waits for an answer
  SteadyTime next_{};
};

}  // namespace tendon
