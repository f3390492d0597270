#pragma once

#include <tendon/base/clock.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/clock_offset.h>

#include <memory>
#include <mutex>

namespace tendon {

/// Reports to a GCM every second how much CPU time and memory this process uses, and estimates the
/// GCM's clock from the replies. Used by one thread; replies arrive in threads of the middleware.
class HealthReporter {
 public:
  /// Sends a report if a second has passed or the channel has changed. If the next report is due
  /// before `next`, sets `next` to the time of the report.
  void Work(const std::shared_ptr<Channel>& channel, SteadyTime now, SteadyTime& next);

 private:
  struct GcmClockOffset {
    std::mutex mutex;
    ClockOffset offset;
  };

  void Report(Channel& channel);

  std::weak_ptr<Channel> channel_;
  std::shared_ptr<GcmClockOffset> clock_;  // shared with handlers of pending replies
  SteadyTime next_{};
};

}  // namespace tendon
