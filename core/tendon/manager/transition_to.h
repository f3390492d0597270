#pragma once

#include <tendon/manager/local_manager.h>

#include <string>

namespace tendon {

/// Brings a component at rest to the state that a file wants. Starts it for kActive and kSuspended;
/// for any other state it stays at rest. It becomes suspended after it was active. If that fails
/// within `patience`, it is stopped, because it was not meant to run. Errors are those of the
/// manager, and tell in which state it is left.
Result<void> TransitionTo(LocalManager& manager, const std::string& component,
                          ComponentState wanted, Patience patience = kPatience);

}  // namespace tendon
