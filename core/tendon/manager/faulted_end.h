#pragma once

#include <tendon/manager/description.h>

#include <string>

namespace tendon {

/// Makes it what a connection is while the component at one of its ends is faulted: pending, with
/// the reason. `fault` is Component::fault().
void SetEndFaulted(ConnectionDescription& connection, const std::string& component,
                   const std::string& fault);

}  // namespace tendon
