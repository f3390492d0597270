#pragma once

#include <program/network_options.h>
#include <tendon/base/result.h>

#include <string>

namespace program {

/// The default address of the broker that distributes rows to many viewers.
inline constexpr const char* kBrokerAddress = "127.0.0.1:10706";

/// Returns the settings with which icebox(1) is the broker for programs with these `options`.
/// Errors: kInvalid if this program was built without Ice; kNotFound if IceStorm is not installed;
/// kDenied if the address is on another machine and there is no certificate, or if the certificate
/// does not belong to the broker.
tendon::Result<std::string> BrokerSettings(const std::string& address,
                                           const NetworkOptions& options);

}  // namespace program
