#pragma once

#include <program/network_options.h>
#include <tendon/base/result.h>

#include <string>

namespace program {

/// Where the broker is that rows reach many viewers by, where nobody says otherwise.
inline constexpr const char* kFanOutAddress = "127.0.0.1:10706";

/// Settings for icebox(1), which make it the broker for programs that talk as `options` say.
/// kInvalid without Ice; kNotFound without IceStorm; kDenied for an address off this machine
/// without a certificate, or one of another name.
tendon::Result<std::string> BrokerSettings(const std::string& address,
                                           const NetworkOptions& options);

}  // namespace program
