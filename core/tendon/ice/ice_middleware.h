#pragma once

#include <tendon/middleware/middleware.h>
#include <tendon/security/credentials.h>

#include <memory>
#include <string>

namespace tendon {

/// Carries frames as invocations over ZeroC Ice (tendon.ice); oneway, except for
/// Delivery::kDirect.
/// Both directions use the opener's connection. Has a communicator of its own with fixed settings:
/// ICE_CONFIG is ignored. `exposure` says whether addresses of other machines are allowed; if so, a
/// warning is logged. Makes the process ignore SIGPIPE.
std::unique_ptr<Middleware> MakeIceMiddleware(Exposure exposure);

/// The same with TLS, for this machine and others. Accepts only peers with a certificate of the
/// same CA. Reads the list of revoked certificates again for each link. kDenied, kNotFound or
/// kInvalid if our own certificate is not valid.
Result<std::unique_ptr<Middleware>> MakeIceMiddleware(const Credentials& credentials);

/// The version of Ice with which this library was built: "3.7.8".
std::string IceVersion();

}  // namespace tendon
