#pragma once

#include <tendon/base/error.h>

#include <string>

namespace tendon {

/// " --gcm 10.0.0.1:10705", to append to a command; empty for the default GCM.
[[nodiscard]] std::string GcmWords(const std::string& address);

/// kUnreachable: "no GCM at 127.0.0.1:10705 (connection refused); start one with: gcm serve".
/// `reason` says why the GCM cannot be reached, and may repeat the address.
[[nodiscard]] Error NoGcm(const std::string& address, const std::string& reason);

}  // namespace tendon
