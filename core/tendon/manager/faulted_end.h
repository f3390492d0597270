#pragma once

#include <tendon/manager/component_description.h>

#include <string>

namespace tendon {

/// Marks a connection as pending because `component`, at one of its ends, is faulted. `fault` is
/// the component's fault(), which becomes the reason.
void SetEndFaulted(ConnectionDescription& connection, const std::string& component,
                   const std::string& fault);

}  // namespace tendon
