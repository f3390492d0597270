#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/client.h>

#include <memory>

namespace console {

/// Polls the GCM every second for the health of its processes while Look() is called.
class HealthFeed {
 public:
  explicit HealthFeed(tendon::GcmClient& client);

  /// The latest health, with its present age; empty if the GCM does not provide it. Never waits.
  [[nodiscard]] tendon::message::SystemHealth Look();

 private:
  struct LatestAnswer;

  tendon::GcmClient& client_;
  const std::shared_ptr<LatestAnswer> latest_;
  tendon::SteadyTime next_{};
};

}  // namespace console
