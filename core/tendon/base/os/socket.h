#pragma once

#include <tendon/base/result.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

namespace tendon::os {

/// Owns one descriptor of a stream socket over TCP; never blocks, is not inherited by child
/// processes, and sends to this machine without a pace.
class Socket {
 public:
  Socket() = default;
  explicit Socket(int descriptor) : descriptor_(descriptor) {}
  Socket(Socket&& other) noexcept;
  Socket& operator=(Socket&& other) noexcept;
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  ~Socket();

  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_ = -1;
};

/// Listens at a host (a name or a number) and port, where 0 is any. Errors: kExists with the holder
/// of the port, kUnreachable for an unknown host, kDenied.
Result<Socket> ListenAt(const std::string& host, std::uint16_t port);

/// Blocks for at most `timeout`, but for asking for a host's name; where `is_over` is given, not
/// much longer than until it says so. Errors: kUnreachable, kTimeout.
Result<Socket> ConnectTo(const std::string& host, std::uint16_t port,
                         std::chrono::milliseconds timeout,
                         const std::function<bool()>& is_over = {});

/// The next connection that waits at a listening socket. kWouldBlock: none; kFailed: out of
/// descriptors or memory.
enum class Accepted { kOne, kWouldBlock, kFailed };
Accepted Accept(const Socket& listening, Socket& connection);

/// Sends what can be sent without waiting: the number of bytes, or nothing when the connection is
/// broken.
std::optional<std::size_t> SendSome(const Socket& socket, std::span<const std::byte> bytes);

/// Receives what is there: its part of `buffer`, which is empty when nothing is, or nothing when
/// the connection has ended.
std::optional<std::span<const std::byte>> ReceiveSome(const Socket& socket,
                                                      std::span<std::byte> buffer);

/// Whether what was sent has been repeated for 1.5 s without an answer: the peer's machine, or the
/// way to it, is gone. A peer that only does not read still answers.
[[nodiscard]] bool HasVanished(const Socket& socket);

/// Where the kernel repeats what was sent, for nobody answers it, closing the socket from now on
/// drops that and tells the peer at once: what else is sent would wait behind it, and of a line
/// that is cut one way only, the peer would not learn. Says whether that is so.
bool DropUnheard(const Socket& socket);
/// The same of the connection of this program between these two ports, whoever made it.
bool DropUnheard(std::uint16_t local_port, std::uint16_t peer_port);

/// Tells the peer that nothing more will come.
void ShutDownSending(const Socket& socket);
/// Nothing more comes or goes; whoever waits for it is told that it has ended.
void ShutDown(int descriptor);
/// The same of the connection of this program between these addresses, as LocalAddress() and
/// PeerAddress() say them. The ports alone may be those of another peer, too.
void ShutDown(const std::string& local, const std::string& peer);

/// As numbers, with brackets around IPv6; "unknown" where the kernel does not know any more.
[[nodiscard]] std::string LocalAddress(const Socket& socket);
[[nodiscard]] std::string PeerAddress(const Socket& socket);

/// For a socket of a library, between these ports of this end and the peer's, 0 for the peer of one
/// that listens: from now on it is not inherited by programs that this one starts, and what it
/// sends to this machine is not paced, as those of Socket.
void AdoptSocket(std::uint16_t local_port, std::uint16_t peer_port);

/// Whether all who listen at a port of this machine are this user's programs.
[[nodiscard]] bool IsHeldByUser(std::uint16_t port);

/// Who listens at a port of this machine: "pid 812 (gcm)", or "another program" where /proc does
/// not show whom; nothing where nobody does.
[[nodiscard]] std::optional<std::string> HolderOf(std::uint16_t port);

/// An error of code kExists: "127.0.0.1:10705 is in use by pid 812 (gcm)", or "by another program"
/// where /proc does not show whom.
[[nodiscard]] Error AddressInUse(const std::string& host, std::uint16_t port);

}  // namespace tendon::os
