#include <tendon/process/lifecycle/configuration_base.h>

namespace tendon {

Fingerprint BaseOf(const std::string& configuration) { return FingerprintOf(configuration); }

Result<void> CheckBase(const message::LifecycleOrder& order, const std::string& now,
                       const std::string& by) {
  const bool is_for_any = order.based_on == Fingerprint();
  if (is_for_any || order.based_on == BaseOf(now)) return {};
  const std::string path = order.process + "/" + order.component;
  return Error{ErrorCode::kFailed, "the configuration of " + path + " was changed meanwhile" + by +
                                       ": nothing was done; to see the configuration: gcm show " +
                                       path + "; then try again"};
}

}  // namespace tendon
