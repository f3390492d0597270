#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/client.h>

#include <memory>

namespace console {

/// Requests the health of the processes from the GCM, every second while Look() is called
/// regularly.
class HealthFeed {
 public:
  explicit HealthFeed(tendon::GcmClient& client);

  /// Returns the latest health, with its present age. Empty if the GCM does not provide it. Never
  /// blocks.
  [[nodiscard]] tendon::message::SystemHealth Look();

 private:
  struct LatestReply;

  tendon::GcmClient& client_;
  const std::shared_ptr<LatestReply> latest_;
  tendon::SteadyTime next_{};
};

}  // namespace console
