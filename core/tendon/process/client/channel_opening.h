#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/context.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>

namespace tendon {

/// A channel that a process wants to another one.
struct WantedChannel {
  std::shared_ptr<Worker> opener;
  std::string address;
  Hello hello;
  std::shared_ptr<ChannelHandler> handler;
  std::chrono::milliseconds timeout{0};  ///< once it is its turn
};

using OpenedChannel = Result<std::shared_ptr<Channel>>;

/// Opens it in its opener, behind those that it opens already: one that hangs holds up no others
/// than these. `done` is called on the worker; once that has stopped, what was opened is closed
/// instead.
void OpenChannel(const ProcessContext& context, const WantedChannel& wanted,
                 std::function<void(const OpenedChannel&)> done);

}  // namespace tendon
