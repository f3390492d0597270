#pragma once

#include <Ice/Ice.h>

#include <memory>
#include <string>

namespace tendon::ice {

/// The local and the peer's address of a socket, as "host:port".
struct SocketAddresses {
  std::string local = "unknown";
  std::string peer = "unknown";
};

/// Returns the IP addresses in the information about a connection; null if it contains none.
std::shared_ptr<Ice::IPConnectionInfo> AddressIn(std::shared_ptr<Ice::ConnectionInfo> info);
SocketAddresses AddressesOf(const Ice::IPConnectionInfo& address);

/// Sets options of a connection's socket with os::AdoptSocket(). Child processes then do not
/// inherit the socket, which would keep its port in use. The kernel does not delay the socket's
/// data. The cost grows with the number of sockets of the process.
void AdoptSocket(const Ice::Connection& connection);

}  // namespace tendon::ice
