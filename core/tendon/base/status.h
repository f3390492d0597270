#pragma once

#include <cstdint>
#include <string_view>

namespace tendon {

/// The outcome of a real-time call: never allocates, never throws, true when the call was executed
/// or accepted for execution.
class [[nodiscard]] Status {
 public:
  enum Code : std::uint8_t {
    kDone,            ///< executed
    kQueued,          ///< accepted; runs in the server's thread
    kNotConnected,    ///< no peer, or the peer is gone
    kNotActive,       ///< the peer is there but does not run
    kQueueFull,       ///< refused: the peer has not caught up
    kNoSample,        ///< nothing has been written yet
    kTimeout,         ///< not executed, and will not be
    kOutcomeUnknown,  ///< started or sent; whether it was executed cannot be known
    kWouldDeadlock,   ///< a wait for one's own thread
    kDenied,          ///< the caller's role does not allow it
    kDisabled,        ///< the peer has switched this command off for now
    kUnsupported,     ///< not to be had this way, as calling what returns something without waiting
    kInvalid,         ///< the argument does not decode
    kFailed,          ///< the server's code threw, or what copied a value
  };

  constexpr Status(Code code) noexcept : code_(code) {}  // NOLINT(google-explicit-constructor)

  constexpr explicit operator bool() const noexcept { return code_ <= kQueued; }
  [[nodiscard]] constexpr Code code() const noexcept { return code_; }
  constexpr bool operator==(const Status&) const = default;

 private:
  Code code_;
};

/// The words a person reads: "queue full", "not connected", ...
[[nodiscard]] std::string_view ToString(Status status) noexcept;

}  // namespace tendon
