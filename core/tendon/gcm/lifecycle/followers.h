#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/gcm_messages.h>

#include <string>
#include <vector>

/// Functions for followers: components that run after another one, and therefore stop with it. The
/// step that stops a component stores its followers as JSON in LifecycleStep::former, so that an
/// undo can start them again.
namespace tendon {

/// Returns the running components that run after this one, directly or indirectly, as text for
/// LifecycleStep::former; empty if there are none.
[[nodiscard]] std::string FollowersText(const Catalogue& catalogue, const std::string& process,
                                        const std::string& component);

/// Returns the components that stopped with the component of the step `stop`.
[[nodiscard]] std::vector<std::string> FollowersOf(const message::LifecycleStep& stop);

/// Checks that the components of FollowersOf() are still as the step `stop` left them.
Result<void> CheckFollowers(const Catalogue& catalogue, const message::LifecycleStep& stop);

/// Returns the orders that start the stopped component of `order` and its followers again, leaders
/// before followers. At the end are orders that suspend the components that were suspended before
/// the stop.
[[nodiscard]] std::vector<message::LifecycleOrder> OrdersToRunAgain(
    const message::LifecycleStep& stop, const message::LifecycleOrder& order);

}  // namespace tendon
