#pragma once

#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/gcm/client.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace console {

/// A component with what its class says of its configuration, and what it was told itself.
struct ConfiguredComponent {
  tendon::ClassDescription of;
  std::string told;            ///< JSON, or empty
  std::uint64_t instance = 0;  ///< of its process
};

/// Asks the component's process; waits for at most `patience`. kFailed where it is of no class.
tendon::Result<ConfiguredComponent> FindConfigured(tendon::GcmClient& client,
                                                   std::chrono::milliseconds patience,
                                                   const tendon::Path& component);

}  // namespace console
