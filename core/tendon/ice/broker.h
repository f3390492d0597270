#pragma once

#include <tendon/base/result.h>
#include <tendon/security/credentials.h>

#include <string>

namespace tendon::ice {

/// The name of the broker, IceStorm, in its certificate.
inline constexpr const char* kBrokerName = "broker";

/// The common name of the broker's objects. With TLS it is public. Without TLS it is derived from
/// the user's cookie, so that other users on this machine cannot find topics, because IceStorm
/// itself does not authenticate.
Result<std::string> BrokerInstance(bool is_certified);

/// Fails with kNotFound, and a text that says what to install, if icebox would not find IceStorm.
Result<void> CheckBrokerIsInstalled();

/// Settings for icebox(1) that make it a broker at `address`, for this machine only.
Result<std::string> BrokerSettings(const std::string& address);
/// The same with TLS: only operators may publish. kInvalid for file names that the settings cannot
/// hold.
Result<std::string> BrokerSettings(const std::string& address, const Credentials& credentials);

}  // namespace tendon::ice
