#pragma once

#include <tendon/gcm/catalog.h>
#include <tendon/gcm/messages.h>

#include <string>
#include <vector>

/// Components that run after another one end when that is stopped. The step of the stop keeps which
/// did, as JSON in LifeStep::former, so that its undo lets them run again.
namespace tendon {

/// Which run after the component, or after one that does, as LifeStep::former of its stop has it;
/// empty where none does.
[[nodiscard]] std::string FollowersText(const Catalog& catalog, const std::string& process,
                                        const std::string& component);

/// The components that ended with that of the step.
[[nodiscard]] std::vector<std::string> FollowersOf(const message::LifeStep& stop);

/// Whether they are still as the stop left them.
Result<void> CheckFollowers(const Catalog& catalog, const message::LifeStep& stop);

/// What lets the component of `order`, which was stopped, and its followers run as before: the
/// starts, each behind that of the one after which it runs, then the suspends.
[[nodiscard]] std::vector<message::LifeOrder> OrdersToRunAgain(const message::LifeStep& stop,
                                                               const message::LifeOrder& order);

}  // namespace tendon
