#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/context.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>

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

/// Opens the channel in the opener's thread, after all earlier requests. Therefore, a hanging peer
/// delays only requests of the same opener. Calls `done` on the worker. If the worker has stopped,
/// closes the channel instead.
void OpenChannel(const ProcessContext& context, const ChannelRequest& wanted,
                 std::function<void(const OpenedChannel&)> done);

}  // namespace tendon
