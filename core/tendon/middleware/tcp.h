#pragma once

#include <tendon/middleware/middleware.h>

#include <memory>

namespace tendon {

/// Makes a middleware that uses plain TCP sockets. A TCP connection carries only frames, one after
/// the other. One thread serves all listeners and links. If the machine of a peer disappears from
/// the network, this is detected within 2 s while data is sent to it, otherwise within 4 s.
/// `exposure` says whether addresses of other machines are allowed; if they are, a warning is
/// logged.
std::unique_ptr<Middleware> MakeTcpMiddleware(Exposure exposure);

}  // namespace tendon
