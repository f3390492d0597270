#pragma once

#include <tendon/base/result.h>
#include <tendon/security/credentials.h>

#include <string>

namespace tendon::ice {

/// The name by its certificate of whoever runs the broker, IceStorm.
inline constexpr const char* kBrokerName = "fan-out";

/// What all of the broker's objects are called by. Under TLS everybody may know it. Without, it
/// follows from the user's cookie, so that nobody else on this machine finds topics: IceStorm
/// itself asks nobody who he is.
Result<std::string> BrokerInstance(bool is_certified);

/// kNotFound, and what to install, where icebox would not find IceStorm.
Result<void> CheckBrokerIsInstalled();

/// Settings for icebox(1), which make it a broker at `address`, on this machine alone.
Result<std::string> BrokerSettings(const std::string& address);
/// The same under TLS: only operators may publish. kInvalid for files of a name that settings
/// cannot hold.
Result<std::string> BrokerSettings(const std::string& address, const Credentials& credentials);

}  // namespace tendon::ice
