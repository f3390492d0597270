#pragma once

#include <program/network_options.h>
#include <tendon/base/result.h>

#include <string>

namespace program {

/// The default address of the broker that distributes rows to many viewers.
inline constexpr const char* kFanOutAddress = "127.0.0.1:10706";

/// The settings with which icebox(1) becomes the broker for programs with these `options`. kInvalid
/// without Ice; kNotFound without IceStorm; kDenied for an address off this machine without a
/// certificate, or with a certificate of another name.
tendon::Result<std::string> BrokerSettings(const std::string& address,
                                           const NetworkOptions& options);

}  // namespace program
