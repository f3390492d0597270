#pragma once

#include <tendon/middleware/middleware.h>
#include <tendon/security/credentials.h>

#include <memory>
#include <string>

namespace tendon {

/// Carries frames as invocations over ZeroC Ice (slice/tendon.ice); oneway, except for Link::Ask().
/// Both directions use the opener's connection. Has a communicator of its own with fixed settings:
/// ICE_CONFIG is ignored. `exposure` says whether addresses off this machine are allowed; if so, a
/// warning is logged. Makes the process ignore SIGPIPE.
std::unique_ptr<Middleware> MakeIceMiddleware(Exposure exposure);

/// The same with TLS, on this machine and off it. Accepts only peers with a certificate of the same
/// CA. Reads the list of revoked certificates anew for each link. kDenied, kNotFound or kInvalid if
/// our own certificate is not valid.
Result<std::unique_ptr<Middleware>> MakeIceMiddleware(const Credentials& credentials);

/// The version of Ice that this was built with: "3.7.8".
std::string IceVersion();

}  // namespace tendon
