#include <gcm_console/feeds/health_feed.h>

#include <mutex>

namespace console {

using tendon::SteadyClock;
using tendon::message::SystemHealth;

struct HealthFeed::LatestReply {
  std::mutex mutex;
  SystemHealth health;
  tendon::SteadyTime when{};
  bool is_asking = false;
};

HealthFeed::HealthFeed(tendon::GcmClient& client)
    : client_(client), latest_(std::make_shared<LatestReply>()) {}

SystemHealth HealthFeed::Look() {
  constexpr std::chrono::milliseconds kBetween(1000);
  const tendon::SteadyTime now = SteadyClock().Now();
  SystemHealth health;
  bool asks = false;
  {
    const std::scoped_lock lock(latest_->mutex);
    health = latest_->health;
    for (auto& process : health.processes) process.age += now - latest_->when;
    asks = now >= next_ && !latest_->is_asking;
    latest_->is_asking = latest_->is_asking || asks;
  }
  if (!asks) return health;
  next_ = now + kBetween;
  client_.GetHealth([latest = latest_](tendon::Result<SystemHealth> reply) {
    const std::scoped_lock lock(latest->mutex);
    latest->health = reply ? *std::move(reply) : SystemHealth{};
    latest->when = SteadyClock().Now();
    latest->is_asking = false;
  });
  return health;
}

}  // namespace console
