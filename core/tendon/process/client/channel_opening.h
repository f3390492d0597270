#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/context.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace tendon {

/// A channel to another process that is to be opened.
struct ChannelRequest {
  std::shared_ptr<Worker> opener;
  std::string address;
  Hello hello;
  std::shared_ptr<ChannelHandler> handler;
  std::chrono::milliseconds timeout{0};  ///< counted from its turn
};

using OpenedChannel = Result<std::shared_ptr<Channel>>;

/// Opens the channel in its opener, after those posted before, so that a peer that hangs delays
/// only these. Calls `done` on the worker. If the worker has stopped, closes the channel instead.
void OpenChannel(const ProcessContext& context, const ChannelRequest& wanted,
                 std::function<void(const OpenedChannel&)> done);

}  // namespace tendon
