#pragma once

#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/gcm/client.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace console {

/// A component with the description of its class and its own configuration.
struct ConfiguredComponent {
  tendon::ClassDescription description;  ///< description of the class
  std::string configuration;             ///< configuration of the component, as JSON; may be empty
  std::uint64_t instance = 0;            ///< instance id of the process
};

/// Requests the data from the component's process, and waits at most `timeout`. Returns kFailed if
/// the component was not created from a class.
tendon::Result<ConfiguredComponent> FindConfigured(tendon::GcmClient& client,
                                                   std::chrono::milliseconds timeout,
                                                   const tendon::Path& component);

}  // namespace console
