#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/proxy/messages.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace tendon {

/// Tells the other end of a connection how many events this one has lost, soon after each change.
/// Of the network thread.
class LossReport {
 public:
  /// `handle` is the connection's, of the other end.
  LossReport(std::shared_ptr<Channel> channel, std::uint32_t handle)
      : channel_(std::move(channel)), handle_(handle) {}

  /// Of one event handler.
  void Set(std::size_t handler, std::uint64_t lost);
  /// Brings `next` forward to when it has something to tell.
  void Tell(SteadyTime now, SteadyTime& next);

 private:
  const std::shared_ptr<Channel> channel_;
  const std::uint32_t handle_;
  SteadyTime earliest_{};
  std::vector<std::uint64_t> lost_;
  message::EventsLost told_;
};

}  // namespace tendon
