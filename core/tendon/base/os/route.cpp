#include <tendon/base/os/route.h>

#include <netdb.h>
#include <sys/socket.h>
#include <tendon/base/os/file.h>
#include <tendon/base/os/process.h>

#include <array>
#include <cerrno>
#include <memory>
#include <optional>
#include <system_error>

namespace tendon::os {
namespace {

constexpr std::string_view kNoRoute = " has no route to ";

using Addresses = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

/// Resolves a host name. Returns null if it cannot be resolved.
Addresses AddressesOf(const std::string& host, std::uint16_t port) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_DGRAM;
  hints.ai_flags = AI_NUMERICSERV;
  addrinfo* found = nullptr;
  const bool is_known =
      getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found) == 0;
  return {is_known ? found : nullptr, &freeaddrinfo};
}

std::optional<std::string> NumericAddress(const sockaddr& address, socklen_t size) {
  std::array<char, NI_MAXHOST> number{};
  const int failure =
      getnameinfo(&address, size, number.data(), number.size(), nullptr, 0, NI_NUMERICHOST);
  return failure == 0 ? std::optional<std::string>(number.data()) : std::nullopt;
}

}  // namespace

std::string WhyNotReached(const std::string& address, int failure) {
  const std::string reason = " (" + std::generic_category().message(failure) + ")";
  const bool is_way_missing = failure == ENETUNREACH || failure == EHOSTUNREACH;
  if (!is_way_missing) return "nobody answers at " + address + reason;
  return "host '" + HostName() + "'" + std::string(kNoRoute) + address + reason;
}

bool IsNoRouteError(std::string_view text) { return text.find(kNoRoute) != text.npos; }

std::string NumberOf(const std::string& host) {
  const Addresses addresses = AddressesOf(host, 0);
  if (!addresses) return host;
  return NumericAddress(*addresses->ai_addr, addresses->ai_addrlen).value_or(host);
}

std::string AddressTowards(const std::string& host, std::uint16_t port) {
  const Addresses addresses = AddressesOf(host, port);
  for (const addrinfo* one = addresses.get(); one != nullptr; one = one->ai_next) {
    const Descriptor socket(::socket(one->ai_family, SOCK_DGRAM | SOCK_CLOEXEC, 0));
    sockaddr_storage local{};
    socklen_t size = sizeof local;
    auto* const raw = reinterpret_cast<sockaddr*>(&local);
    const bool has_way = connect(socket.get(), one->ai_addr, one->ai_addrlen) == 0 &&
                         getsockname(socket.get(), raw, &size) == 0;
    if (has_way) return NumericAddress(*raw, size).value_or("");
  }
  return {};
}

}  // namespace tendon::os
