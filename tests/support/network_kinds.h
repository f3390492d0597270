#pragma once

#include <tendon/middleware/middleware.h>

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

/// A sort of network on which tests of whole processes run.
struct NetworkKind {
  /// Makes the middleware of one more process.
  using Join = std::function<std::shared_ptr<tendon::Middleware>()>;

  std::string name;
  /// Makes a network of its own.
  std::function<Join()> make;
};

inline void PrintTo(const NetworkKind& kind, std::ostream* out) { *out << kind.name; }

/// Loopback and plain sockets, and Ice where it is built.
std::vector<NetworkKind> NetworkKinds();
/// The first two of them.
std::vector<NetworkKind> PlainNetworkKinds();
