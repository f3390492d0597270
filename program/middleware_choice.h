#pragma once

#include <tendon/base/result.h>
#include <tendon/middleware/middleware.h>

#include <memory>
#include <string>
#include <vector>

namespace program {

/// The middlewares this program was built with, the default first: "ice" where Ice is built in, and
/// "tcp".
std::vector<std::string> MiddlewareNames();

/// Makes the one of this name. kInvalid names those there are.
tendon::Result<std::shared_ptr<tendon::Middleware>> MakeMiddleware(const std::string& name,
                                                                   tendon::Exposure exposure);

/// Where the GCM is: `option` if it is not empty, else $TENDON_GCM, else this machine. A host alone
/// means the port where a GCM usually is.
std::string GcmAddress(const std::string& option);

}  // namespace program
