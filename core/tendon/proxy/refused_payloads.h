#pragma once

#include <tendon/lockfree/counter.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/rate_limited_warning.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace tendon {

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
  void Tell();
  /// Any thread: logs "'cloud' of 80 000 000 B exceeds max_payload 67 108 864 B of
  /// robot/arm/Cloud", at most once in ten seconds, with the count.
  void Log(const std::string& member, std::size_t size);

  [[nodiscard]] std::uint64_t logged() const { return complaints_.count(); }

 private:
  const std::string interface_;
  std::map<std::uint32_t, std::string> members_;  // by the part of the handle that fits into a note
  Published<std::uint64_t> note_{0};
  SharedCounter<> notes_;
  std::uint64_t told_ = 0;  // number of logged notes; network thread
  RateLimitedWarning complaints_{"network"};
};

}  // namespace tendon
