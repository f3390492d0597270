#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/connections/peer_link.h>
#include <tendon/process/context.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// A request to open a channel to another process.
struct ChannelRequest {
  std::shared_ptr<Worker> opener;
  std::string address;
  Hello hello;
  std::shared_ptr<ChannelHandler> handler;
  std::chrono::milliseconds timeout{0};  ///< counted from the start of the attempt
};

using OpenedChannel = Result<std::shared_ptr<Channel>>;

/// Opens the channel in the opener's thread, after earlier requests. So a hanging peer delays only
/// requests of the same opener. Calls `done` on the worker; if the worker has stopped, closes the
/// channel instead.
void OpenChannel(const ProcessContext& context, const ChannelRequest& wanted,
                 std::function<void(const OpenedChannel&)> done);

/// A request for the provided interface of another process that a required interface here needs.
struct InterfaceRequest {
  message::OpenInterface open;
  std::chrono::milliseconds read_deadline{0};
  std::vector<std::string> mirrored{};     ///< functions that read local copies
  std::shared_ptr<SerialExecutor> line{};  ///< line for its events, if needed
};

using OpenedInterface = Result<std::shared_ptr<ProvidedInterfaceProxy>>;

/// Asks the peer for the interface and makes its proxy, which is registered at the link under
/// `wanted.open.handle`. Calls `done` in a thread of the middleware, before anything that the peer
/// sends to the proxy.
void OpenProvided(const std::shared_ptr<NetworkThread>& network,
                  const std::shared_ptr<PeerLink>& link, const InterfaceRequest& wanted,
                  const std::function<void(const OpenedInterface&)>& done);

}  // namespace tendon
