#pragma once

#include <tendon/base/result.h>
#include <tendon/process/lifecycle/lifecycle_messages.h>

#include <string>

/// Detects two concurrent changes of one configuration: the second change is refused, because it is
/// based on a configuration that was replaced.
namespace tendon {

/// Returns the fingerprint of the configuration on which an order is based; it is never all zeros.
/// `configuration` is JSON as in the catalogue, or empty for the defaults.
[[nodiscard]] Fingerprint BaseOf(const std::string& configuration);

/// Checks that the order may replace the configuration `now`. If it may not, the text of kFailed
/// says what to check. `by` names the author of `now`, for example " by gcm set at 2025-11-21
/// 15:40:03", or is empty.
Result<void> CheckBase(const message::LifecycleOrder& order, const std::string& now,
                       const std::string& by = "");

}  // namespace tendon
