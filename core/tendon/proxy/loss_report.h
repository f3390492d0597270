#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/proxy/connection_messages.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace tendon {

/// Reports to the other end of a connection how many events this end has lost, soon after each
/// change. Network thread only.
class LossReport {
 public:
  /// `handle` is the number of the connection at the other end.
  LossReport(std::shared_ptr<Channel> channel, std::uint32_t handle)
      : channel_(std::move(channel)), handle_(handle) {}

  /// Sets the total number of lost events of one event handler.
  void Set(std::size_t handler, std::uint64_t lost);
  /// Sends a report if a total has changed. Lowers `next` to the time of the next report.
  void Tell(SteadyTime now, SteadyTime& next);

 private:
  const std::shared_ptr<Channel> channel_;
  const std::uint32_t handle_;
  SteadyTime earliest_{};
  std::vector<std::uint64_t> lost_;
  message::EventsLost told_;
};

}  // namespace tendon
