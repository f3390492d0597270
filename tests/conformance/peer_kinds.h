#pragma once

#include <tendon/middleware/middleware.h>

#include <memory>
#include <string>

namespace tendon::conformance {

/// The middleware with the name `kind`, or null if it was not built.
std::shared_ptr<Middleware> MiddlewareOf(const std::string& kind);

}  // namespace tendon::conformance
