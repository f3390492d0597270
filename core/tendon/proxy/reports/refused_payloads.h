#pragma once

#include <tendon/lockfree/counter.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/complaints.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace tendon {

/// Values over kMaxPayload that a proxy was to send, for the log. Who calls a function or raises an
/// event gets a status and may not log: it leaves a note, which the network thread finds.
class RefusedPayloads {
 public:
  /// `interface` is whose members they are of: "robot/arm/Cloud".
  explicit RefusedPayloads(std::string interface) : interface_(std::move(interface)) {}

  /// Before a note is left of it.
  void Add(std::uint32_t handle, std::string member);
  /// Any thread; wait-free. A newer note replaces an older one.
  void Note(std::uint32_t handle, std::size_t size) noexcept;
  /// Network thread: logs what was noted.
  void Tell();
  /// Any thread: logs that "'cloud' of 80 000 000 B exceeds max_payload 67 108 864 B of
  /// robot/arm/Cloud"; one in ten seconds, with their number.
  void Log(const std::string& member, std::size_t size);

  [[nodiscard]] std::uint64_t logged() const { return complaints_.count(); }

 private:
  const std::string interface_;
  std::map<std::uint32_t, std::string> members_;  // by handle, without what a note has no room for
  Published<std::uint64_t> note_{0};
  SharedCounter<> notes_;
  std::uint64_t told_ = 0;  // of them; network thread
  Complaints complaints_{"network"};
};

}  // namespace tendon
