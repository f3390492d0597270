#pragma once

#include <tendon/base/os/socket.h>

#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

namespace tendon::os {

/// Waits for any of many sockets. Any thread may call all functions except Wait().
class Poller {
 public:
  /// A socket that is ready, by the key with which it was added.
  struct Event {
    std::uint64_t key = 0;
    /// Data has arrived, or the peer has closed the connection; a read shows which.
    bool readable = false;
    bool writable = false;
  };
  enum class Watch { kNothing, kReads, kReadsAndWrites };

  Poller();
  Poller(const Poller&) = delete;
  Poller& operator=(const Poller&) = delete;

  /// `key` must not be 0. The socket must be removed before it is closed.
  void Add(const Socket& socket, std::uint64_t key, Watch watch);
  void Change(const Socket& socket, std::uint64_t key, Watch watch);
  void Remove(const Socket& socket);

  /// Returns the sockets that are ready; none if woken or if `timeout` has passed. Valid until the
  /// next call.
  std::span<const Event> Wait(std::chrono::milliseconds timeout);
  void Wake();

 private:
  Socket poll_;  // epoll and event descriptors; Socket closes them
  Socket wake_;
  std::vector<Event> events_;
};

}  // namespace tendon::os
