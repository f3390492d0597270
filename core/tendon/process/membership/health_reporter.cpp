#include <tendon/process/membership/health_reporter.h>

#include <tendon/base/os/process.h>
#include <tendon/process/membership_messages.h>

#include <algorithm>
#include <chrono>

namespace tendon {
namespace {

constexpr std::chrono::milliseconds kBetween(1000);
constexpr std::chrono::milliseconds kTimeout(500);

}  // namespace

void HealthReporter::Work(const std::shared_ptr<Channel>& channel, SteadyTime now,
                          SteadyTime& next) {
  if (channel_.lock() != channel) {
    channel_ = channel;
    clock_ = std::make_shared<GcmClockOffset>();
    next_ = now;
  }
  if (now >= next_) {
    next_ = now + kBetween;
    Report(*channel);
  }
  next = std::min(next, next_);
}

void HealthReporter::Report(Channel& channel) {
  const os::Usage usage = os::OwnUsage();
  const SteadyTime sent = SteadyClock().Now();
  message::Health health{.cpu_time = usage.cpu_time.count(),
                         .memory = usage.memory,
                         .time = sent.time_since_epoch().count()};
  {
    const std::scoped_lock lock(clock_->mutex);
    const ClockOffset::Estimate gcm = clock_->offset.At(sent);
    if (gcm.uncertainty != ClockOffset::kUnknown) {
      health.clock_offset = -gcm.offset;
      health.clock_uncertainty = gcm.uncertainty;
    }
  }
  channel.Request<message::GcmClock>(
      message::kReportHealth, 0, health, kTimeout,
      [clock = clock_, sent](const Result<message::GcmClock>& reply) {
        if (!reply) return;  // the next report replaces this one
        const std::scoped_lock lock(clock->mutex);
        const SteadyTime there{std::chrono::nanoseconds(reply->time)};
        clock->offset.Add(sent, there, SteadyClock().Now());
      },
      kOwnLane);
}

}  // namespace tendon
