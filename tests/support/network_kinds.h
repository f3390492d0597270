#pragma once

#include <tendon/middleware/middleware.h>

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

/// A kind of network for tests with whole processes.
struct NetworkKind {
  /// Makes the middleware of a further process in the network.
  using Join = std::function<std::shared_ptr<tendon::Middleware>()>;

  std::string name;
  /// Makes a new network.
  std::function<Join()> make;
};

inline void PrintTo(const NetworkKind& kind, std::ostream* out) { *out << kind.name; }

/// Returns loopback and plain sockets, and Ice if it is built.
std::vector<NetworkKind> NetworkKinds();
/// Returns only loopback and plain sockets.
std::vector<NetworkKind> PlainNetworkKinds();
