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
#include <vector>

namespace tendon::client {

/// Channels to processes, opened on demand in a thread of their own and kept while they are open.
/// Thread-safe.
class ProcessLinks final : public std::enable_shared_from_this<ProcessLinks> {
 public:
  using SharedChannel = std::shared_ptr<Channel>;
  /// Must not block.
  using Use = std::function<void(Result<SharedChannel>)>;
  /// Returns the current description of a process, or the reason why it cannot be reached.
  using Resolve = std::function<Result<ProcessDescription>(const std::string& process)>;

  /// Our name and highest role on these channels, and how long a process that does not answer may
  /// delay requests to others.
  struct Options {
    std::string name;
    Role role = Role::kOperator;
    std::chrono::milliseconds patience{1000};
  };

  /// The middleware outlives Stop().
  ProcessLinks(Middleware& middleware, Resolve resolve, Options options);

  /// Call it before the first WithChannel(). The listener gets the notices of all channels, and
  /// their OnClosed().
  void SetNoticeListener(std::weak_ptr<ChannelHandler> listener) {
    listener_ = std::move(listener);
  }
  /// Calls `use` with an open channel, or the reason why there is none: at once, or in the thread
  /// that opens it.
  void WithChannel(const std::string& process, Use use);
  /// Closes a channel to another instance of the process than `instance`.
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
