#pragma once

#include <tendon/base/error.h>

#include <string>

namespace tendon {

/// kUnreachable: "no GCM at 127.0.0.1:10705 (connection refused); start one with: gcm serve".
/// `reason` is why it could not be reached, which may say the address again; the command names it
/// where it is not the usual one.
[[nodiscard]] Error NoGcm(const std::string& address, const std::string& reason);

}  // namespace tendon
