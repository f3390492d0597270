#pragma once

#include <program/network_options.h>
#include <tendon/base/result.h>

#include <string>

namespace program {

/// The default address of the broker that distributes rows to many viewers.
inline constexpr const char* kBrokerAddress = "127.0.0.1:10706";

/// The settings that make icebox(1) the broker for programs with these `options`. kInvalid without
/// Ice; kNotFound without IceStorm; kDenied for an address of another machine without a
/// certificate, or with a certificate of another name.
tendon::Result<std::string> BrokerSettings(const std::string& address,
                                           const NetworkOptions& options);

}  // namespace program
