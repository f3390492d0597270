#pragma once

#include <tendon/base/rate_limited_warning.h>
#include <tendon/lockfree/counter.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>
#include <tendon/proxy/connection_messages.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
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
  void Report(SteadyTime now, SteadyTime& next);

 private:
  const std::shared_ptr<Channel> channel_;
  const std::uint32_t handle_;
  SteadyTime earliest_{};
  std::vector<std::uint64_t> lost_;
  message::EventsLost reported_;
};

/// Logs values above kMaxPayload that a proxy refused to send. The thread that calls a function
/// must not log; it leaves a note, which the network thread logs.
class RefusedPayloads {
 public:
  /// `interface` is the interface of the members: "robot/arm/Cloud".
  explicit RefusedPayloads(std::string interface) : interface_(std::move(interface)) {}

  /// Adds a member. Call it before the first note of the member.
  void Add(std::uint32_t handle, std::string member);
  /// Any thread; wait-free. A newer note replaces an older one.
  void Note(std::uint32_t handle, std::size_t size) noexcept;
  /// Network thread: logs the note.
  void Report();
  /// Any thread: logs "'cloud' of 80 000 000 B exceeds max_payload 67 108 864 B of
  /// robot/arm/Cloud", at most once in ten seconds, with the count.
  void Log(const std::string& member, std::size_t size);

  [[nodiscard]] std::uint64_t logged() const { return complaints_.count(); }

 private:
  const std::string interface_;
  std::map<std::uint32_t, std::string> members_;  // by the part of the handle that fits into a note
  Published<std::uint64_t> note_{0};
  SharedCounter<> notes_;
  std::uint64_t reported_ = 0;  // number of logged notes; network thread
  RateLimitedWarning complaints_{"network"};
};

}  // namespace tendon
