#pragma once

#include <tendon/middleware/middleware.h>

#include <memory>

namespace tendon {

/// A middleware of plain sockets: a TCP connection carries frames one after the other, nothing
/// else. One thread serves all listeners and links. A vanished peer is detected within 2 s if data
/// is sent to it, otherwise within 4 s. `exposure` says whether addresses of other machines are
/// allowed; if so, a warning is logged.
std::unique_ptr<Middleware> MakeTcpMiddleware(Exposure exposure);

}  // namespace tendon
