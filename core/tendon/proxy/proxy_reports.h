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
#include <utility>
#include <vector>

namespace tendon {

/// Reports to the other end of a connection how many events this end has lost, soon after each
/// change. Used only in the network thread.
class LossReport {
 public:
  /// `handle` is the number that the other end has issued for the connection.
  LossReport(std::shared_ptr<Channel> channel, std::uint32_t handle)
      : channel_(std::move(channel)), handle_(handle) {}

  /// Sets the total number of lost events of one event handler.
  void Set(std::size_t handler, std::uint64_t lost);
  /// Sends a report if a total has changed. If the next report is due before `next`, sets `next` to
  /// the time of the report.
  void Report(SteadyTime now, SteadyTime& next);

 private:
  const std::shared_ptr<Channel> channel_;
  const std::uint32_t handle_;
  SteadyTime earliest_{};
  std::vector<std::uint64_t> lost_;
  message::EventsLost reported_;
};

/// Logs the values that a proxy has refused to send because they are larger than kMaxPayload. The
/// thread that calls a function must not log, so it stores a note, and the network thread logs the
/// note.
class RefusedPayloads {
 public:
  /// `interface` is the interface of the members: "robot/arm/Cloud".
  explicit RefusedPayloads(std::string interface) : interface_(std::move(interface)) {}

  /// Adds a member. Must be called before the first note about the member.
  void Add(std::uint32_t handle, std::string member);
  /// Any thread: stores a note about a value of `size` bytes. A newer note replaces an older one.
  /// Wait-free.
  void Note(std::uint32_t handle, std::size_t size) noexcept;
  /// Network thread: logs the note if there is a new one.
  void Report();
  /// Any thread: logs "'cloud' of 80 000 000 B exceeds max_payload 67 108 864 B of
  /// robot/arm/Cloud". Such messages are logged at most once in ten seconds, with their number.
  void Log(const std::string& member, std::size_t size);

  [[nodiscard]] std::uint64_t logged() const { return warnings_.count(); }

 private:
  const std::string interface_;
  std::map<std::uint32_t, std::string> members_;  // by the low bits of the handle, as in a note
  Published<std::uint64_t> note_{0};
  SharedCounter<> notes_;
  // Value of notes_ at the last Report(); used only in the network thread.
  std::uint64_t reported_ = 0;
  RateLimitedWarning warnings_{"network"};
};

}  // namespace tendon
