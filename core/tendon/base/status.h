#pragma once

#include <cstdint>
#include <string_view>

namespace tendon {

/// The outcome of a real-time call. Never allocates or throws. Converts to true if the call was
/// executed or accepted for execution.
class [[nodiscard]] Status {
 public:
  enum Code : std::uint8_t {
    kDone,            ///< executed
    kQueued,          ///< accepted; runs in the server's thread
    kNotConnected,    ///< there is no peer
    kNotActive,       ///< the peer exists but is not running
    kQueueFull,       ///< refused, because the peer has not yet executed earlier calls
    kNoSample,        ///< nothing has been written yet
    kTimeout,         ///< not executed in time, and will not be executed later
    kOutcomeUnknown,  ///< started or sent, but the outcome is unknown
    kWouldDeadlock,   ///< the caller would wait for its own thread
    kDenied,          ///< the caller's role does not allow it
    kDisabled,        ///< the peer has switched this command off for now
    kUnsupported,     ///< not possible, for example a result of a call that does not wait
    kInvalid,         ///< the argument cannot be decoded
    kFailed,          ///< the server's code or the copy of a value threw an exception
  };

  constexpr Status(Code code) noexcept : code_(code) {}  // NOLINT(google-explicit-constructor)

  constexpr explicit operator bool() const noexcept { return code_ <= kQueued; }
  [[nodiscard]] constexpr Code code() const noexcept { return code_; }
  constexpr bool operator==(const Status&) const = default;

 private:
  Code code_;
};

/// Returns the text for people: "queue full", "not connected", ...
[[nodiscard]] std::string_view ToString(Status status) noexcept;

}  // namespace tendon
