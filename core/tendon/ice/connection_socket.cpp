#include <tendon/ice/connection_socket.h>

#include <tendon/base/os/socket.h>
#include <tendon/middleware/middleware.h>

#include <cstdint>
#include <string_view>
#include <utility>

namespace tendon::ice {
namespace {

std::string Place(std::string host, int port) {
  constexpr std::string_view kMapped = "::ffff:";  // IPv4 on an IPv6 socket
  if (host.starts_with(kMapped)) host.erase(0, kMapped.size());
  return ToString(HostPort{std::move(host), static_cast<std::uint16_t>(port)});
}

}  // namespace

std::shared_ptr<Ice::IPConnectionInfo> AddressIn(std::shared_ptr<Ice::ConnectionInfo> info) {
  while (info->underlying) info = info->underlying;
  return std::dynamic_pointer_cast<Ice::IPConnectionInfo>(info);
}

SocketAddresses AddressesOf(const Ice::IPConnectionInfo& address) {
  return {.local = Place(address.localAddress, address.localPort),
          .peer = Place(address.remoteAddress, address.remotePort)};
}

void AdoptSocket(const Ice::Connection& connection) {
  try {
    const auto address = AddressIn(connection.getInfo());
    if (!address) return;
    os::AdoptSocket(static_cast<std::uint16_t>(address->localPort),
                    static_cast<std::uint16_t>(address->remotePort));
  } catch (const Ice::Exception&) {
    // The connection is already closed.
  }
}

}  // namespace tendon::ice
