#pragma once

#include <tendon/middleware/middleware.h>
#include <tendon/security/credentials.h>

#include <memory>
#include <string>

namespace tendon {

/// Makes a middleware that sends frames as invocations of ZeroC Ice (see tendon.ice). The
/// invocations are oneway, except for Delivery::kDirect. Both directions use the connection that
/// the opener has made. The middleware has its own communicator with fixed settings, so ICE_CONFIG
/// is ignored. If `exposure` allows addresses of other machines, a warning is logged. From now on,
/// the process ignores SIGPIPE.
std::unique_ptr<Middleware> MakeIceMiddleware(Exposure exposure);

/// Makes an Ice middleware with TLS, for this machine and others. Accepts only peers with a
/// certificate of the same CA. Reads the list of revoked certificates again for each link. Fails
/// with kDenied, kNotFound or kInvalid if the certificate in `credentials` is not valid.
Result<std::unique_ptr<Middleware>> MakeIceMiddleware(const Credentials& credentials);

/// Returns the version of Ice with which this library was built: "3.7.8".
std::string IceVersion();

}  // namespace tendon
