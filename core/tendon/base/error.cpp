#include <tendon/base/error.h>

#include <utility>

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

std::string ReasonOf(std::exception_ptr thrown) {
  std::string reason;
  while (thrown) {
    if (!reason.empty()) reason += ": ";
    try {
      std::rethrow_exception(std::exchange(thrown, nullptr));
    } catch (const std::exception& error) {
      reason += error.what();
      const auto* const outer = dynamic_cast<const std::nested_exception*>(&error);
      if (outer != nullptr) thrown = outer->nested_ptr();
    } catch (...) {
      reason += "an exception that does not derive from std::exception";
    }
  }
  return reason;
}

ConfigurationError AddedTooLate(const std::string& part, const std::string& whole,
                                std::string_view state) {
  return ConfigurationError("cannot add " + part + " to " + whole + " (" + std::string(state) +
                            "): add it in the constructor");
}

}  // namespace tendon
