#pragma once

#include <tendon/base/os/socket.h>

#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

namespace tendon::os {

/// Waits until any of many sockets is ready. All functions except Wait() are thread-safe.
class Poller {
 public:
  /// Reports a socket that is ready. `key` is the key with which the socket was added.
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

  /// Waits until a socket is ready, Wake() is called or `timeout` has passed. Returns the sockets
  /// that are ready, which may be none. The result is valid until the next Wait().
  std::span<const Event> Wait(std::chrono::milliseconds timeout);
  void Wake();

 private:
  Socket poll_;  // an epoll descriptor; a Socket, so that it is closed automatically
  Socket wake_;  // an eventfd; a Socket, so that it is closed automatically
  std::vector<Event> events_;
};

}  // namespace tendon::os
