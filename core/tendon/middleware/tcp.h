#pragma once

#include <tendon/middleware/middleware.h>

#include <memory>

namespace tendon {

/// Plain sockets: frames one after the other on a TCP connection, nothing else. One thread serves
/// all listeners and links. An accepted link whose first frame takes over 3 s, or on which
/// anything else does, is closed. `exposure` says whether addresses off this machine are allowed;
/// if so, a warning is logged.
std::unique_ptr<Middleware> MakeTcpMiddleware(Exposure exposure);

}  // namespace tendon
