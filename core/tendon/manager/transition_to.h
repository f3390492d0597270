#pragma once

#include <tendon/manager/local_manager.h>

#include <string>

namespace tendon {

/// Brings a component at rest to the state that a file requests. For kActive, starts it; for
/// kSuspended, starts and then suspends it; for any other state, does nothing. If the suspension
/// fails within `patience`, stops the component, because it must not run. Errors are those of the
/// manager, plus the state in which the component is left.
Result<void> TransitionTo(LocalManager& manager, const std::string& component,
                          ComponentState wanted, Patience patience = kPatience);

}  // namespace tendon
