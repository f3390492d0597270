#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/client.h>

#include <memory>

namespace console {

/// Asks the GCM each second how its processes do, as long as somebody looks.
class HealthFeed {
 public:
  explicit HealthFeed(tendon::GcmClient& client);

  /// What was heard last, with its age as of now; nothing where the GCM does not say. Never waits.
  [[nodiscard]] tendon::message::SystemHealth Look();

 private:
  struct Heard;

  tendon::GcmClient& client_;
  const std::shared_ptr<Heard> heard_;
  tendon::SteadyTime next_{};
};

}  // namespace console
