#pragma once

#include <tendon/base/error.h>

#include <string>

namespace tendon {

/// " --gcm 10.0.0.1:10705", behind a command for the GCM there; empty for the usual one.
[[nodiscard]] std::string GcmWords(const std::string& address);

/// kUnreachable: "no GCM at 127.0.0.1:10705 (connection refused); start one with: gcm serve".
/// `reason` is why it could not be reached, which may say the address again.
[[nodiscard]] Error NoGcm(const std::string& address, const std::string& reason);

}  // namespace tendon
