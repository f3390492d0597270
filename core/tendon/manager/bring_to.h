#pragma once

#include <tendon/manager/local_manager.h>

#include <string>

namespace tendon {

/// Brings a component at rest to the state that a file wants of it: starts it for kActive and
/// kSuspended, and lets it rest else. It becomes suspended by way of active: where that does not
/// succeed within `patience`, it is stopped, for it was not to run. Errors as those of the manager,
/// which say what became of it.
Result<void> BringTo(LocalManager& manager, const std::string& component, ComponentState wanted,
                     Patience patience = kPatience);

}  // namespace tendon
