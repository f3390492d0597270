#pragma once

#include <tendon/middleware/hello.h>
#include <tendon/middleware/middleware.h>
#include <tendon/process/telemetry_client.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace tendon {

/// Returns the current address of a process, or the reason why it is unknown. Not called in the
/// middleware's threads.
using ResolveAddress = std::function<Result<std::string>(const std::string& process)>;

/// Returns the address of the multicast broker, or the reason why it is unknown. Not called in the
/// middleware's threads; may be null.
using FindBroker = std::function<Result<std::string>()>;

/// Makes a client that opens channels to processes on demand, with `mine` as its Hello. A
/// subscription to every row uses the broker, if the process and the middleware support this. If
/// there is no broker, or if it delivers nothing for some seconds, the process sends the rows
/// directly; the client logs this. `timeout` is the time to wait for a reply to ReadPast(); the
/// longer it is, the more time a busy process has to accept a link for it.
std::unique_ptr<TelemetryClient> MakeTelemetryClient(
    std::shared_ptr<Middleware> middleware, ResolveAddress resolve, Hello mine,
    FindBroker find_broker = nullptr,
    std::chrono::milliseconds timeout = std::chrono::milliseconds(2000));

}  // namespace tendon
