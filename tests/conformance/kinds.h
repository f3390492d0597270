#pragma once

#include <tendon/middleware/middleware.h>

#include <functional>
#include <memory>
#include <ostream>
#include <string>

namespace tendon::conformance {

/// Two middlewares that can communicate, as if each were in its own process.
struct Pair {
  std::shared_ptr<Middleware> server;
  std::shared_ptr<Middleware> client;
};

/// One middleware under test.
struct Kind {
  std::string name;
  std::function<Pair(Exposure)> make;
};

inline void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

}  // namespace tendon::conformance
