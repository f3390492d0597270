#include <program/middleware_choice.h>
#include <tendon/base/name.h>
#include <tendon/middleware/tcp.h>
#include <tendon/process/process.h>

#ifdef TENDON_WITH_ICE
#include <tendon/ice/ice_middleware.h>
#endif

#include <cstdlib>
#include <functional>
#include <utility>

namespace program {
namespace {

using Maker = std::function<std::unique_ptr<tendon::Middleware>(tendon::Exposure)>;

/// The default first.
const std::vector<std::pair<std::string, Maker>>& Makers() {
  static const std::vector<std::pair<std::string, Maker>> kMakers = {
#ifdef TENDON_WITH_ICE
      {"ice", &tendon::MakeIceMiddleware},
#endif
      {"tcp", &tendon::MakeTcpMiddleware},
  };
  return kMakers;
}

}  // namespace

std::vector<std::string> MiddlewareNames() {
  std::vector<std::string> names;
  for (const auto& [name, maker] : Makers()) names.push_back(name);
  return names;
}

tendon::Result<std::shared_ptr<tendon::Middleware>> MakeMiddleware(const std::string& name,
                                                                   tendon::Exposure exposure) {
  for (const auto& [known, make] : Makers()) {
    if (known == name) return std::shared_ptr<tendon::Middleware>(make(exposure));
  }
  std::string all;
  for (const std::string& known : MiddlewareNames()) all += (all.empty() ? "" : ", ") + known;
  return tendon::Error{tendon::ErrorCode::kInvalid,
                       "no middleware '" + name + "' in this program; there is: " + all};
}

std::string GcmAddress(const std::string& option) {
  std::string address = option;
  // NOLINTNEXTLINE(concurrency-mt-unsafe): read only
  if (const char* known = std::getenv("TENDON_GCM"); address.empty() && known != nullptr) {
    address = known;
  }
  if (address.empty()) address = "127.0.0.1";
  const bool is_host = address.find(':') == std::string::npos || address.ends_with(']');
  return is_host ? address + ":" + std::to_string(tendon::kDefaultGcmPort) : address;
}

}  // namespace program
