#include <gcm_console/screen/health_feed.h>

#include <mutex>

namespace console {

using tendon::SteadyClock;
using tendon::message::SystemHealth;

struct HealthFeed::Heard {
  std::mutex mutex;
  SystemHealth health;
  tendon::SteadyTime when{};
  bool is_asking = false;
};

HealthFeed::HealthFeed(tendon::GcmClient& client)
    : client_(client), heard_(std::make_shared<Heard>()) {}

SystemHealth HealthFeed::Look() {
  constexpr std::chrono::milliseconds kBetween(1000);
  const tendon::SteadyTime now = SteadyClock().Now();
  SystemHealth health;
  bool asks = false;
  {
    const std::scoped_lock lock(heard_->mutex);
    health = heard_->health;
    for (auto& process : health.processes) process.age += now - heard_->when;
    asks = now >= next_ && !heard_->is_asking;
    heard_->is_asking = heard_->is_asking || asks;
  }
  if (!asks) return health;
  next_ = now + kBetween;
  client_.GetHealth([heard = heard_](tendon::Result<SystemHealth> answer) {
    const std::scoped_lock lock(heard->mutex);
    heard->health = answer ? *std::move(answer) : SystemHealth{};
    heard->when = SteadyClock().Now();
    heard->is_asking = false;
  });
  return health;
}

}  // namespace console
