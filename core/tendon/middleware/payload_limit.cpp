#include <tendon/middleware/payload_limit.h>

#include <tendon/middleware/middleware.h>

#include <string>

namespace tendon {
namespace {

/// "67 108 864 B"
std::string InBytes(std::size_t size) {
  std::string digits = std::to_string(size);
  for (std::size_t left = digits.size(); left > 3;) {
    left -= 3;
    digits.insert(left, 1, ' ');
  }
  return digits + " B";
}

}  // namespace

Error ExceedsMaxPayload(std::string_view what, std::size_t size, std::string_view owner) {
  std::string sentence(what);
  sentence += " of " + InBytes(size) + " exceeds max_payload " + InBytes(kMaxPayload);
  if (!owner.empty()) sentence += " of " + std::string(owner);
  return {ErrorCode::kInvalid, sentence};
}

Error WhyNotSent(Status status, const std::string& peer, std::size_t size) {
  switch (status.code()) {
    case Status::kQueueFull:
      return {ErrorCode::kFailed, peer + " reads too slowly: " + std::to_string(kSendWindow) +
                                      " bytes wait to be sent; try again later"};
    case Status::kInvalid:
      return ExceedsMaxPayload("a message", size);
    default:
      return {ErrorCode::kUnreachable, peer + " is not connected"};
  }
}

}  // namespace tendon
