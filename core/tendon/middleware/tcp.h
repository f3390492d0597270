#pragma once

#include <tendon/middleware/middleware.h>

#include <memory>

namespace tendon {

/// Plain sockets: frames one after the other on a TCP connection, nothing else. One thread serves
/// all listeners and links. A peer that vanishes is noticed within 2 s if data is sent to it, else
/// within 4 s. `exposure` says whether addresses off this machine are allowed; if so, a warning is
/// logged.
std::unique_ptr<Middleware> MakeTcpMiddleware(Exposure exposure);

}  // namespace tendon
