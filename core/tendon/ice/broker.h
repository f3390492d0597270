#pragma once

#include <tendon/base/result.h>
#include <tendon/security/credentials.h>

#include <string>

namespace tendon::ice {

/// The name of the broker, IceStorm, in its certificate.
inline constexpr const char* kBrokerName = "broker";

/// Returns the name that all objects of the broker contain. With TLS, the name is public. Without
/// TLS, the name is derived from the user's cookie, because IceStorm does not authenticate. Other
/// users on this machine do not know this name, so they cannot find topics.
Result<std::string> BrokerInstance(bool is_certified);

/// Checks that icebox can find IceStorm. If not, fails with kNotFound; the error says what to
/// install.
Result<void> CheckBrokerIsInstalled();

/// Returns settings that make icebox(1) a broker at `address`, for this machine only.
Result<std::string> BrokerSettings(const std::string& address);
/// Returns settings for a broker with TLS. Only operators may publish to this broker. Fails with
/// kInvalid if the settings cannot contain the name of a file.
Result<std::string> BrokerSettings(const std::string& address, const Credentials& credentials);

}  // namespace tendon::ice
