#include <tendon/base/os/socket.h>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <tendon/base/os/route.h>
#include <tendon/base/text.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace tendon::os {
namespace {

namespace fs = std::filesystem;

std::string TextOf(int failure) { return std::generic_category().message(failure); }

std::string Name(const std::string& host, std::uint16_t port) {
  const bool is_ipv6 = host.find(':') != std::string::npos;
  return (is_ipv6 ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

using Addresses = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

Result<Addresses> Resolve(const std::string& host, std::uint16_t port) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_NUMERICSERV;
  addrinfo* found = nullptr;
  const int failure = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
  if (failure != 0) {
    return Error{ErrorCode::kUnreachable,
                 "host '" + host + "' is unknown (" + gai_strerror(failure) + ")"};
  }
  return Addresses(found, &freeaddrinfo);
}

Socket NewSocket(const addrinfo& address) {
  return Socket(socket(address.ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
}

void Set(const Socket& socket, int level, int option, int value = 1) {
  setsockopt(socket.descriptor(), level, option, &value, sizeof(value));
}

/// Waits until the connection is established. Returns 0, or the error number if it has failed.
int WaitUntilConnected(const Socket& socket, std::chrono::steady_clock::time_point deadline,
                       const std::function<bool()>& is_over) {
  using std::chrono::milliseconds;
  constexpr milliseconds kLook(50);  // time between two checks of is_over()
  while (true) {
    auto left = std::chrono::ceil<milliseconds>(deadline - std::chrono::steady_clock::now());
    if (left.count() <= 0) return ETIMEDOUT;
    if (is_over && is_over()) return ECANCELED;
    if (is_over) left = std::min(left, kLook);
    pollfd wait{socket.descriptor(), POLLOUT, 0};
    const int ready = poll(&wait, 1, static_cast<int>(left.count()));
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
    if (ready < 0) return errno;
    int failure = 0;
    socklen_t size = sizeof(failure);
    getsockopt(socket.descriptor(), SOL_SOCKET, SO_ERROR, &failure, &size);
    return failure;
  }
}

/// Returns the port of one end of a connection, or 0 if the kernel knows no address. `query` is
/// getsockname or getpeername.
template <typename Query>
std::uint16_t PortOf(int descriptor, Query query) {
  sockaddr_storage address{};
  socklen_t size = sizeof(address);
  if (query(descriptor, reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  if (address.ss_family == AF_INET) {
    return ntohs(reinterpret_cast<const sockaddr_in&>(address).sin_port);
  }
  const bool is_ipv6 = address.ss_family == AF_INET6;
  return is_ipv6 ? ntohs(reinterpret_cast<const sockaddr_in6&>(address).sin6_port) : 0;
}

/// One end of a connection, as a numeric address and port.
struct End {
  std::array<char, NI_MAXHOST> host{};
  std::array<char, NI_MAXSERV> port{};
};

/// Returns one end of a connection; empty if the kernel no longer knows it. `query` is getsockname
/// or getpeername.
template <typename Query>
std::optional<End> EndOf(int descriptor, Query query) {
  sockaddr_storage address{};
  socklen_t size = sizeof(address);
  auto* const raw = reinterpret_cast<sockaddr*>(&address);
  End end;
  if (query(descriptor, raw, &size) != 0 ||
      getnameinfo(raw, size, end.host.data(), end.host.size(), end.port.data(), end.port.size(),
                  NI_NUMERICHOST | NI_NUMERICSERV) != 0) {
    return std::nullopt;
  }
  return end;
}

template <typename Query>
std::string AddressOf(int descriptor, Query query) {
  const auto end = EndOf(descriptor, query);
  if (!end) return "unknown";
  constexpr std::string_view kMapped = "::ffff:";  // prefix of an IPv4 address on an IPv6 socket
  const std::string_view number = end->host.data();
  const bool is_mapped = number.starts_with(kMapped) && number.find('.') != number.npos;
  const std::string text(is_mapped ? number.substr(kMapped.size()) : number);
  return (text.find(':') != text.npos ? "[" + text + "]:" : text + ":") + end->port.data();
}

/// Selects the congestion control Reno for a connection within one machine. Such a connection has
/// no network link, so a congestion control that models the link, such as BBR, only delays large
/// messages by a timer. Reno has no such model: its pacing, if any, is far faster than the traffic.
/// Every kernel has Reno.
void DoNotPaceOnOneMachine(int descriptor) {
  constexpr std::string_view kWithoutPace = "reno";
  const auto local = EndOf(descriptor, getsockname);
  const auto peer = EndOf(descriptor, getpeername);
  if (!local || !peer || local->host != peer->host) return;
  setsockopt(descriptor, IPPROTO_TCP, TCP_CONGESTION, kWithoutPace.data(), kWithoutPace.size());
}

/// Sets up a connection: it sends small messages at once, and detects within 4 s that a peer has
/// vanished while the connection is idle.
void SetUp(const Socket& connection) {
  Set(connection, IPPROTO_TCP, TCP_NODELAY);
  Set(connection, SOL_SOCKET, SO_KEEPALIVE);
  Set(connection, IPPROTO_TCP, TCP_KEEPIDLE, 1);   // s
  Set(connection, IPPROTO_TCP, TCP_KEEPINTVL, 1);  // s
  Set(connection, IPPROTO_TCP, TCP_KEEPCNT, 2);
  DoNotPaceOnOneMachine(connection.descriptor());
}

/// The fields that we need of a listening socket in a kernel table, as text.
struct ListeningSocket {
  std::string user;
  std::string inode;
};

/// Returns the sockets that listen at `port` according to one kernel table.
std::vector<ListeningSocket> ListenersIn(const char* table, std::uint16_t port) {
  constexpr int kHex = 16;
  std::vector<ListeningSocket> found;
  std::ifstream lines(table);
  std::string line;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string skipped;
    std::string local;
    std::string state;
    ListeningSocket socket;
    words >> skipped >> local >> skipped >> state >> skipped >> skipped >> skipped >> socket.user >>
        skipped >> socket.inode;
    const auto colon = local.rfind(':');
    if (state != "0A" || colon == local.npos) continue;  // 0A: listening
    unsigned number = 0;
    std::from_chars(local.data() + colon + 1, local.data() + local.size(), number, kHex);
    if (number == port) found.push_back(std::move(socket));
  }
  return found;
}

std::vector<ListeningSocket> ListenersAt(std::uint16_t port) {
  auto found = ListenersIn("/proc/net/tcp", port);
  for (auto& socket : ListenersIn("/proc/net/tcp6", port)) found.push_back(std::move(socket));
  return found;
}

bool HoldsSocket(const fs::path& process, const std::string& inode) {
  std::error_code ignored;
  const std::string link = "socket:[" + inode + "]";
  for (fs::directory_iterator file(process / "fd", ignored), end; file != end;
       file.increment(ignored)) {
    if (fs::read_symlink(*file, ignored).native() == link) return true;
  }
  return false;
}

/// Returns the program that listens at `port`, for example "pid 812 (gcm)".
std::string ListenerAt(std::uint16_t port) {
  const auto sockets = ListenersAt(port);
  std::error_code ignored;
  for (fs::directory_iterator process("/proc", ignored), end; !sockets.empty() && process != end;
       process.increment(ignored)) {
    const std::string pid = process->path().filename();
    if (pid.find_first_not_of("0123456789") != pid.npos) continue;
    if (!HoldsSocket(process->path(), sockets.front().inode)) continue;
    std::string program;
    std::getline(std::ifstream(process->path() / "comm"), program);
    return "pid " + pid + " (" + program + ")";
  }
  return "another program";
}

template <typename Call>
void ForEachDescriptor(Call call) {
  std::error_code ignored;
  for (fs::directory_iterator one("/proc/self/fd", ignored), end; one != end;
       one.increment(ignored)) {
    call(std::atoi(one->path().filename().c_str()));
  }
}

/// Calls `call` with the descriptor of each connection of this program between two ports.
template <typename Call>
void ForEachBetween(std::uint16_t local_port, std::uint16_t peer_port, Call call) {
  ForEachDescriptor([&](int descriptor) {
    if (PortOf(descriptor, getsockname) == local_port &&
        PortOf(descriptor, getpeername) == peer_port) {
      call(descriptor);
    }
  });
}

bool ResetIfUnacknowledgedAt(int descriptor) {
  tcp_info info{};
  socklen_t size = sizeof(info);
  if (getsockopt(descriptor, IPPROTO_TCP, TCP_INFO, &info, &size) != 0) return false;
  if (info.tcpi_unacked == 0 || info.tcpi_retransmits < 2) return false;  // one loss is normal
  const linger at_once{.l_onoff = 1, .l_linger = 0};
  return setsockopt(descriptor, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once) == 0;
}

}  // namespace

Socket::Socket(Socket&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

Socket& Socket::operator=(Socket&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

Socket::~Socket() {
  if (descriptor_ >= 0) close(descriptor_);
}

Result<Socket> ListenAt(const std::string& host, std::uint16_t port) {
  const auto addresses = Resolve(host, port);
  if (!addresses) return addresses.error();
  const addrinfo& address = **addresses;
  Socket socket = NewSocket(address);
  Set(socket, SOL_SOCKET, SO_REUSEADDR);
  if (bind(socket.descriptor(), address.ai_addr, address.ai_addrlen) != 0 ||
      listen(socket.descriptor(), SOMAXCONN) != 0) {
    if (errno == EADDRINUSE) return AddressInUse(host, port);
    return Error{ErrorCode::kDenied, "cannot listen at " + Name(host, port) + ": " + TextOf(errno)};
  }
  return socket;
}

Result<Socket> ConnectTo(const std::string& host, std::uint16_t port,
                         std::chrono::milliseconds timeout, const std::function<bool()>& is_over) {
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  const auto addresses = Resolve(host, port);
  if (!addresses) return addresses.error();
  int failure = 0;
  for (const addrinfo* address = addresses->get(); address != nullptr; address = address->ai_next) {
    Socket socket = NewSocket(*address);
    const bool is_ready = socket.descriptor() >= 0 &&
                          connect(socket.descriptor(), address->ai_addr, address->ai_addrlen) == 0;
    failure = is_ready ? 0 : errno;
    if (failure == EINPROGRESS) failure = WaitUntilConnected(socket, deadline, is_over);
    // A connection from a free port to the same port would reach itself.
    if (failure == 0 && LocalAddress(socket) == PeerAddress(socket)) failure = ECONNREFUSED;
    if (failure == ECANCELED) break;
    if (failure != 0) continue;
    SetUp(socket);
    return socket;
  }
  if (failure == ETIMEDOUT) {
    return Error{ErrorCode::kTimeout,
                 "no reply from " + Name(host, port) + " within " + Milliseconds(timeout)};
  }
  return Error{ErrorCode::kUnreachable, WhyNotReached(Name(host, port), failure)};
}

AcceptResult Accept(const Socket& listening, Socket& connection) {
  while (true) {
    Socket socket(accept4(listening.descriptor(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (socket.descriptor() >= 0) {
      SetUp(socket);
      connection = std::move(socket);
      return AcceptResult::kOne;
    }
    if (errno == EAGAIN) return AcceptResult::kWouldBlock;
    if (errno != EINTR && errno != ECONNABORTED) return AcceptResult::kFailed;
  }
}

std::optional<std::size_t> SendSome(const Socket& socket, std::span<const std::byte> bytes) {
  while (true) {
    const ssize_t sent = send(socket.descriptor(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent >= 0) return static_cast<std::size_t>(sent);
    if (errno == EAGAIN) return 0;
    if (errno != EINTR) return std::nullopt;
  }
}

std::optional<std::span<const std::byte>> ReceiveSome(const Socket& socket,
                                                      std::span<std::byte> buffer) {
  while (true) {
    const ssize_t size = recv(socket.descriptor(), buffer.data(), buffer.size(), 0);
    if (size > 0) return buffer.first(static_cast<std::size_t>(size));
    if (size == 0) return std::nullopt;
    if (errno == EAGAIN) return std::span<const std::byte>();
    if (errno != EINTR) return std::nullopt;
  }
}

bool ResetIfUnacknowledged(const Socket& socket) {
  return ResetIfUnacknowledgedAt(socket.descriptor());
}

bool ResetIfUnacknowledged(std::uint16_t local_port, std::uint16_t peer_port) {
  bool is_unacknowledged = false;
  ForEachBetween(local_port, peer_port, [&is_unacknowledged](int descriptor) {
    is_unacknowledged = ResetIfUnacknowledgedAt(descriptor) || is_unacknowledged;
  });
  return is_unacknowledged;
}

bool IsPeerUnreachable(const Socket& socket) {
  // TCP_USER_TIMEOUT is not used, because it also disconnects a peer that acknowledges but has
  // stopped reading. The kernel retransmits after about 0.2 s and doubles the wait each time: the
  // third retransmission is sent after 1.6 s.
  constexpr unsigned kRepetitions = 3;
  tcp_info info{};
  socklen_t size = sizeof(info);
  if (getsockopt(socket.descriptor(), IPPROTO_TCP, TCP_INFO, &info, &size) != 0) return false;
  return info.tcpi_unacked > 0 && info.tcpi_retransmits >= kRepetitions;
}

void ShutDownSending(const Socket& socket) { shutdown(socket.descriptor(), SHUT_WR); }

void ShutDown(int descriptor) { shutdown(descriptor, SHUT_RDWR); }

void ShutDown(const std::string& local, const std::string& peer) {
  ForEachDescriptor([&](int descriptor) {
    if (AddressOf(descriptor, getsockname) == local && AddressOf(descriptor, getpeername) == peer) {
      ShutDown(descriptor);
    }
  });
}

std::string LocalAddress(const Socket& socket) {
  return AddressOf(socket.descriptor(), getsockname);
}

std::string PeerAddress(const Socket& socket) {
  return AddressOf(socket.descriptor(), getpeername);
}

void AdoptSocket(std::uint16_t local_port, std::uint16_t peer_port) {
  ForEachBetween(local_port, peer_port, [](int descriptor) {
    fcntl(descriptor, F_SETFD, FD_CLOEXEC);
    DoNotPaceOnOneMachine(descriptor);
  });
}

bool IsHeldByUser(std::uint16_t port) {
  const auto sockets = ListenersAt(port);
  const std::string user = std::to_string(geteuid());
  return !sockets.empty() && std::all_of(sockets.begin(), sockets.end(),
                                         [&](const auto& socket) { return socket.user == user; });
}

std::optional<std::string> HolderOf(std::uint16_t port) {
  if (ListenersAt(port).empty()) return std::nullopt;
  return ListenerAt(port);
}

Error AddressInUse(const std::string& host, std::uint16_t port) {
  return {ErrorCode::kExists, Name(host, port) + " is in use by " + ListenerAt(port)};
}

}  // namespace tendon::os
