#include <tendon/process/membership/no_gcm.h>

#include <string_view>

namespace tendon {
namespace {

constexpr std::string_view kUsualAddress = "127.0.0.1:10705";

/// "nobody answers at 127.0.0.1:10705 (Connection refused)" without what is said anyway.
std::string Briefly(const std::string& reason) {
  const std::size_t open = reason.find(" (");
  if (!reason.starts_with("nobody ") || open == reason.npos || reason.back() != ')') return reason;
  return reason.substr(open + 2, reason.size() - open - 3);
}

}  // namespace

Error NoGcm(const std::string& address, const std::string& reason) {
  const std::string which = address == kUsualAddress ? "" : " --gcm " + address;
  return {ErrorCode::kUnreachable,
          "no GCM at " + address + " (" + Briefly(reason) + "); start one with: gcm serve" + which};
}

}  // namespace tendon
