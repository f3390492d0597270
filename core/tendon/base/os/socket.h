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

/// Owns the descriptor of a TCP stream socket. The socket never blocks, child processes do not
/// inherit it, and TCP does not delay (pace) data to peers on this machine.
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

/// Listens at a host (a name or a numeric address) and a port. If the port is 0, the kernel chooses
/// one. Errors: kExists if another program listens at the port (the text names the program),
/// kUnreachable if the host is unknown, kDenied otherwise.
Result<Socket> ListenAt(const std::string& host, std::uint16_t port);

/// Connects to a host and a port. Blocks for at most `timeout`, plus the time to resolve the host's
/// name. If `is_over` is given, the wait ends soon after `is_over` returns true. Errors:
/// kUnreachable, kTimeout.
Result<Socket> ConnectTo(const std::string& host, std::uint16_t port,
                         std::chrono::milliseconds timeout,
                         const std::function<bool()>& is_over = {});

/// Accept() takes the next pending connection of a listening socket. Its result is kWouldBlock if
/// no connection is pending, and kFailed if descriptors or memory are exhausted.
enum class AcceptResult { kOne, kWouldBlock, kFailed };
AcceptResult Accept(const Socket& listening, Socket& connection);

/// Sends as much as possible without waiting. Returns the number of bytes, or no value if the
/// connection is broken.
std::optional<std::size_t> SendSome(const Socket& socket, std::span<const std::byte> bytes);

/// Receives the available bytes without waiting. Returns the part of `buffer` that holds them; the
/// part is empty if no bytes are available. Returns no value if the connection has ended.
std::optional<std::span<const std::byte>> ReceiveSome(const Socket& socket,
                                                      std::span<std::byte> buffer);

/// True if sent data was retransmitted for 1.5 s without an acknowledgement. Then the peer's
/// machine, or the network path to it, is down. A peer that has only stopped reading still
/// acknowledges.
[[nodiscard]] bool IsPeerUnreachable(const Socket& socket);

/// Makes a later close reset the connection if sent data is being retransmitted without
/// acknowledgement. The reset drops that data and reaches the peer at once; a normal close would
/// wait behind the data and never reach a peer over a link that is cut in one direction. Returns
/// true if such data exists.
bool ResetIfUnacknowledged(const Socket& socket);
/// Like the function above, but finds this program's connection by its two ports. The connection
/// may belong to a library.
bool ResetIfUnacknowledged(std::uint16_t local_port, std::uint16_t peer_port);

/// Closes the sending direction. The peer then knows that no more data will come.
void ShutDownSending(const Socket& socket);
/// Closes both directions. A thread that waits for the socket wakes up and finds that the
/// connection has ended.
void ShutDown(int descriptor);
/// Like the function above, but finds this program's connection by its two addresses, in the form
/// that LocalAddress() and PeerAddress() return. Ports alone are not enough, because another peer
/// may use the same port.
void ShutDown(const std::string& local, const std::string& peer);

/// The numeric address and the port of one end of a connection, with brackets around IPv6;
/// "unknown" if the kernel no longer knows the address.
[[nodiscard]] std::string LocalAddress(const Socket& socket);
[[nodiscard]] std::string PeerAddress(const Socket& socket);

/// Applies the settings of Socket to a socket that a library has opened: child processes do not
/// inherit it, and TCP does not delay (pace) its data to peers on this machine. `peer_port` is 0
/// for a listening socket.
void AdoptSocket(std::uint16_t local_port, std::uint16_t peer_port);

/// True if only programs of this user listen at a port of this machine.
[[nodiscard]] bool IsHeldByUser(std::uint16_t port);

/// Returns the program that listens at a port of this machine: "pid 812 (gcm)", or "another
/// program" if /proc does not show it. Returns no value if no program listens.
[[nodiscard]] std::optional<std::string> HolderOf(std::uint16_t port);

/// Returns an error with code kExists: "127.0.0.1:10705 is in use by pid 812 (gcm)", or "by another
/// program" if /proc does not show it.
[[nodiscard]] Error AddressInUse(const std::string& host, std::uint16_t port);

}  // namespace tendon::os
