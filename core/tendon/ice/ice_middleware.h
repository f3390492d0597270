#pragma once

#include <tendon/middleware/middleware.h>
#include <tendon/security/credentials.h>

#include <memory>
#include <string>

namespace tendon {

/// Frames as invocations over ZeroC Ice (slice/tendon.ice), oneway but for those of Link::Ask(),
/// both directions on the connection that the opener made. Has a communicator of its own, with
/// settings of its own: ICE_CONFIG is ignored. `exposure` says whether addresses off this machine
/// are allowed; if so, a warning is logged. Makes the process ignore SIGPIPE.
std::unique_ptr<Middleware> MakeIceMiddleware(Exposure exposure);

/// The same under TLS, on this machine and off it: speaks only to peers that show a certificate of
/// the same CA. The list of the revoked is read anew for each link. kDenied, kNotFound or kInvalid
/// where one's own certificate is not good.
Result<std::unique_ptr<Middleware>> MakeIceMiddleware(const Credentials& credentials);

/// Of the Ice that this was built with: "3.7.8".
std::string IceVersion();

}  // namespace tendon
