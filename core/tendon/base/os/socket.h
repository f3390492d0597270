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
/// inherit it, and data to this machine is not paced.
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

/// Listens at a host (a name or a number) and a port; 0 is any port. Errors: kExists with the
/// holder of the port, kUnreachable for an unknown host, kDenied.
Result<Socket> ListenAt(const std::string& host, std::uint16_t port);

/// Blocks for at most `timeout`, apart from looking up a host's name. If `is_over` is given, the
/// wait ends soon after it returns true. Errors: kUnreachable, kTimeout.
Result<Socket> ConnectTo(const std::string& host, std::uint16_t port,
                         std::chrono::milliseconds timeout,
                         const std::function<bool()>& is_over = {});

/// Accepts the next pending connection of a listening socket. kWouldBlock: there is none; kFailed:
/// out of descriptors or memory.
enum class Accepted { kOne, kWouldBlock, kFailed };
Accepted Accept(const Socket& listening, Socket& connection);

/// Sends as much as possible without waiting. Returns the number of bytes, or no value if the
/// connection is broken.
std::optional<std::size_t> SendSome(const Socket& socket, std::span<const std::byte> bytes);

/// Receives the available bytes. Returns the part of `buffer` that holds them, which is empty if
/// there are none, or no value if the connection has ended.
std::optional<std::span<const std::byte>> ReceiveSome(const Socket& socket,
                                                      std::span<std::byte> buffer);

/// True if sent data was retransmitted for 1.5 s without an acknowledgement: the peer's machine, or
/// the network path to it, is down. A peer that has only stopped reading still acknowledges.
[[nodiscard]] bool IsPeerUnreachable(const Socket& socket);

/// Makes a later close reset the connection if sent data is being retransmitted without
/// acknowledgement. The reset drops that data and reaches the peer at once; a normal close would
/// wait behind the data and never reach a peer over a link that is cut in one direction. Returns
/// true if such data exists.
bool ResetIfUnacknowledged(const Socket& socket);
/// The same for this program's connection between these two ports, for example one of a library.
bool ResetIfUnacknowledged(std::uint16_t local_port, std::uint16_t peer_port);

/// Tells the peer that nothing more will come.
void ShutDownSending(const Socket& socket);
/// Ends traffic in both directions; a thread that waits for the socket wakes and sees the end.
void ShutDown(int descriptor);
/// The same for this program's connection between these addresses, as LocalAddress() and
/// PeerAddress() print them. Another peer may have the same ports.
void ShutDown(const std::string& local, const std::string& peer);

/// Numeric, with brackets around IPv6; "unknown" if the kernel no longer knows the address.
[[nodiscard]] std::string LocalAddress(const Socket& socket);
[[nodiscard]] std::string PeerAddress(const Socket& socket);

/// Applies the settings of Socket to a socket of a library, given by its local port and the peer's
/// port (0 for a listening socket): child processes do not inherit it, and its data to this machine
/// is not paced.
void AdoptSocket(std::uint16_t local_port, std::uint16_t peer_port);

/// True if only programs of this user listen at a port of this machine.
[[nodiscard]] bool IsHeldByUser(std::uint16_t port);

/// The listener at a port of this machine: "pid 812 (gcm)", or "another program" if /proc does not
/// show it; nothing if there is none.
[[nodiscard]] std::optional<std::string> HolderOf(std::uint16_t port);

/// An error of code kExists: "127.0.0.1:10705 is in use by pid 812 (gcm)", or "by another program"
/// if /proc does not show it.
[[nodiscard]] Error AddressInUse(const std::string& host, std::uint16_t port);

}  // namespace tendon::os
