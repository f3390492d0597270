#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/process_description.h>
#include <tendon/process/worker.h>
#include <tendon/security/role.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace tendon::client {

/// Channels to processes. A separate thread opens a channel when it is first needed. The channel is
/// used until it closes. Thread-safe.
class ProcessLinks final : public std::enable_shared_from_this<ProcessLinks> {
 public:
  using SharedChannel = std::shared_ptr<Channel>;
  /// Receives an open channel, or an error that says why there is no channel. Must not block.
  using Use = std::function<void(Result<SharedChannel>)>;
  /// Returns the current description of a process, or an error that says why it cannot be reached.
  using Resolve = std::function<Result<ProcessDescription>(const std::string& process)>;

  /// The name and the role are shown to each process; `role` is the highest role that the program
  /// has there. `timeout` limits the opening of a channel. One thread opens all channels, so a
  /// process that does not answer delays requests to other processes by up to `timeout`.
  struct Options {
    std::string name;
    Role role = Role::kOperator;
    std::chrono::milliseconds timeout{1000};
  };

  /// The middleware must exist until Stop() returns.
  ProcessLinks(Middleware& middleware, Resolve resolve, Options options);

  /// Sets the listener that receives the notices and the closing of all channels. Must be called
  /// before the first WithChannel().
  void SetNoticeListener(std::weak_ptr<ChannelHandler> listener) {
    listener_ = std::move(listener);
  }
  /// Calls `use` with an open channel, or with an error that says why there is no channel. If the
  /// channel is already open, calls `use` at once; otherwise later, in the thread that opens the
  /// channel.
  void WithChannel(const std::string& process, Use use);
  /// Closes the channel to a process if it leads to another instance than `instance`.
  void Drop(const std::string& process, std::uint64_t instance);
  void Stop();

 private:
  class Handler;
  struct ProcessLink {
    SharedChannel channel;     // null while opening
    std::vector<Use> waiting;  // requests that wait for the channel
  };

  void Open(const std::string& process);
  Result<SharedChannel> TryOpen(const std::string& process);
  void OnChannelClosed(const Channel* channel);

  Middleware& middleware_;
  const Resolve resolve_;
  const Options options_;
  std::weak_ptr<ChannelHandler> listener_;
  std::mutex mutex_;
  bool stopped_ = false;
  std::map<std::string, ProcessLink> links_;
  Worker opener_{"client-links"};
};

}  // namespace tendon::client
