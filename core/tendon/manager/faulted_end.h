#pragma once

#include <tendon/manager/component_description.h>

#include <string>

namespace tendon {

/// Makes the connection pending, with the reason, because `component` at one of its ends is
/// faulted. `fault` is its Component::fault().
void SetEndFaulted(ConnectionDescription& connection, const std::string& component,
                   const std::string& fault);

}  // namespace tendon
