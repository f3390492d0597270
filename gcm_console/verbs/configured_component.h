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
  tendon::ClassDescription description;  ///< of its class
  std::string configuration;             ///< its own, as JSON, or empty
  std::uint64_t instance = 0;            ///< the instance id of its process
};

/// Asks the component's process; waits at most `patience`. kFailed if it has no class.
tendon::Result<ConfiguredComponent> FindConfigured(tendon::GcmClient& client,
                                                   std::chrono::milliseconds patience,
                                                   const tendon::Path& component);

}  // namespace console
