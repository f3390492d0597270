#include <tendon/base/os/route.h>
#include <tendon/process/membership/no_gcm.h>
#include <tendon/process/process.h>

namespace tendon {
namespace {

/// The text in brackets: "Connection refused" for "nobody answers at 127.0.0.1:10705 (Connection
/// refused)".
std::string Briefly(const std::string& reason) {
  const std::size_t open = reason.find(" (");
  if (!reason.starts_with("nobody ") || open == reason.npos || reason.back() != ')') return reason;
  return reason.substr(open + 2, reason.size() - open - 3);
}

}  // namespace

std::string GcmWords(const std::string& address) {
  const bool is_usual = address == "127.0.0.1:" + std::to_string(kDefaultGcmPort);
  return is_usual ? "" : " --gcm " + address;
}

Error NoGcm(const std::string& address, const std::string& reason) {
  if (os::IsNoRouteError(reason)) {
    return {ErrorCode::kUnreachable, "no route to the GCM at " + address + ": " + reason +
                                         "; add a route on that host, or give an address of "
                                         "the GCM that it can reach"};
  }
  return {ErrorCode::kUnreachable, "no GCM at " + address + " (" + Briefly(reason) +
                                       "); start one with: gcm serve" + GcmWords(address)};
}

}  // namespace tendon
