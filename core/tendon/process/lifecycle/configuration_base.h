#pragma once

#include <tendon/base/result.h>
#include <tendon/process/lifecycle/lifecycle_messages.h>

#include <string>

/// Detects two concurrent changes of one configuration. The second change is refused, because it is
/// based on an outdated configuration.
namespace tendon {

/// Returns the fingerprint of a configuration, which identifies the base of an order. The
/// fingerprint is never all zeros. `configuration` is JSON as in the catalogue, or empty for the
/// defaults.
[[nodiscard]] Fingerprint BaseOf(const std::string& configuration);

/// Checks that the order may replace the present configuration `now`. Otherwise returns kFailed;
/// the text says what to check. `by` names the program that made the present configuration, for
/// example " by gcm set at 2025-11-21 15:40:03"; it may be empty.
Result<void> CheckBase(const message::LifecycleOrder& order, const std::string& now,
                       const std::string& by = "");

}  // namespace tendon
