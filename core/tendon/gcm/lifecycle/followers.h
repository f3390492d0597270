#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/gcm_messages.h>

#include <string>
#include <vector>

/// Functions for followers: components that run after another component, and therefore stop with
/// it. The step that stops a component stores its followers as JSON in LifecycleStep::former, so
/// that an undo can start them again.
namespace tendon {

/// Returns the running components that run after this component, directly or indirectly, as text
/// for LifecycleStep::former. Returns an empty text if there are no followers.
[[nodiscard]] std::string FollowersText(const Catalogue& catalogue, const std::string& process,
                                        const std::string& component);

/// Returns the components that stopped with the component of the step `stop`.
[[nodiscard]] std::vector<std::string> FollowersOf(const message::LifecycleStep& stop);

/// Checks that the followers have not changed since the step `stop`.
Result<void> CheckFollowers(const Catalogue& catalogue, const message::LifecycleStep& stop);

/// Returns the orders that start the stopped component of `order` and its followers again, leaders
/// before followers. The last orders suspend the components that were suspended before the stop.
[[nodiscard]] std::vector<message::LifecycleOrder> OrdersToRunAgain(
    const message::LifecycleStep& stop, const message::LifecycleOrder& order);

}  // namespace tendon
