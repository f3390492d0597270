#include <tendon/base/error.h>

namespace tendon {

std::string_view ToString(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::kFailed:
      return "failed";
    case ErrorCode::kInvalid:
      return "invalid";
    case ErrorCode::kUnreachable:
      return "unreachable";
    case ErrorCode::kNotFound:
      return "not found";
    case ErrorCode::kExists:
      return "exists";
    case ErrorCode::kIncompatible:
      return "incompatible";
    case ErrorCode::kTimeout:
      return "timeout";
    case ErrorCode::kDenied:
      return "denied";
  }
  return "unknown error";
}

}  // namespace tendon
