#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/gcm_messages.h>

#include <string>
#include <vector>

/// Components that run after another one stop with it. The step of the stop keeps them as JSON in
/// LifecycleStep::former, so that an undo can start them again.
namespace tendon {

/// The components that run after this one, directly or indirectly, as text for
/// LifecycleStep::former; empty if there are none.
[[nodiscard]] std::string FollowersText(const Catalogue& catalogue, const std::string& process,
                                        const std::string& component);

/// The components that the step `stop` stopped in addition to its own component.
[[nodiscard]] std::vector<std::string> FollowersOf(const message::LifecycleStep& stop);

/// Checks that these components are still as the stop left them.
Result<void> CheckFollowers(const Catalogue& catalogue, const message::LifecycleStep& stop);

/// The orders that restore the stopped component of `order` and its followers: first the starts,
/// leaders before followers, then the suspends.
[[nodiscard]] std::vector<message::LifecycleOrder> OrdersToRunAgain(
    const message::LifecycleStep& stop, const message::LifecycleOrder& order);

}  // namespace tendon
