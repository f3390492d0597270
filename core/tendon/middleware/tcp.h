#pragma once

#include <tendon/middleware/middleware.h>

#include <memory>

namespace tendon {

/// Makes a middleware that uses plain TCP sockets. A TCP connection carries only frames, one after
/// the other. One thread serves all listeners and links. If the machine of a peer disappears from
/// the network, the links to it are closed within 2 s while data is sent, otherwise within 4 s.
/// If `exposure` allows addresses of other machines, a warning is logged.
std::unique_ptr<Middleware> MakeTcpMiddleware(Exposure exposure);

}  // namespace tendon
