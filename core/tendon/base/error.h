#pragma once

#include <cstdint>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tendon {

/// The kind of failure. Programs derive their exit code from it, and viewers use it to decide what
/// to do next.
enum class ErrorCode : std::int32_t {
  kFailed,        ///< the operation was refused or failed
  kInvalid,       ///< an argument, a file or a message is malformed
  kUnreachable,   ///< no program answers at the address
  kNotFound,      ///< no such process, component, interface, member or file
  kExists,        ///< the name or the address is taken
  kIncompatible,  ///< the two sides do not fit together
  kTimeout,       ///< no reply in time; the outcome is unknown
  kDenied,        ///< the role does not allow it
};

/// The reason why a request was refused: one sentence that says what failed, where, and what to do
/// next.
struct Error {
  ErrorCode code = ErrorCode::kFailed;
  std::string message;

  bool operator==(const Error&) const = default;
};

/// True if a retry is pointless, because the peer has refused the request. kExists is such a
/// refusal: the peer already has the name or the connection.
[[nodiscard]] constexpr bool IsFinal(ErrorCode code) noexcept {
  return code == ErrorCode::kIncompatible || code == ErrorCode::kInvalid ||
         code == ErrorCode::kDenied || code == ErrorCode::kExists;
}

/// Returns "failed", "not found", ...
[[nodiscard]] std::string_view ToString(ErrorCode code) noexcept;

/// Returns the message of an exception, followed by the messages of the exceptions that caused it
/// (std::nested_exception): "no arm: no port".
[[nodiscard]] std::string ReasonOf(std::exception_ptr thrown);

/// A wiring mistake in a program, such as a duplicate interface name or an invalid period. Thrown
/// while a component is constructed, never in a cycle.
class ConfigurationError : public std::runtime_error {
 public:
  /// Creates an error with code kInvalid.
  using std::runtime_error::runtime_error;
  explicit ConfigurationError(const Error& error)
      : std::runtime_error(error.message), code_(error.code) {}

  [[nodiscard]] ErrorCode code() const noexcept { return code_; }

 private:
  ErrorCode code_ = ErrorCode::kInvalid;
};

/// Returns the error for a part that the author of a component adds too late: "cannot add command
/// 'Stop' to interface 'Control' (sealed): add it in the constructor". `state` is the state of
/// `whole` ("sealed"), or empty.
[[nodiscard]] ConfigurationError AddedTooLate(const std::string& part, const std::string& whole,
                                              std::string_view state = "sealed");

}  // namespace tendon
