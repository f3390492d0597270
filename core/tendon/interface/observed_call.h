#pragma once

#include <tendon/base/status.h>
#include <tendon/interface/command.h>
#include <tendon/interface/interface_description.h>
#include <tendon/payload/schema.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace tendon {

/// The outcome of a call, as its observers see it.
enum class CallOutcome : std::int32_t {
  kExecuted,  ///< the component has executed it
  kFailed,    ///< code of the component threw an exception
  kRefused,   ///< the component has not accepted it
  kExpired,   ///< accepted, but not executed, because its caller had stopped waiting
  kDropped,   ///< accepted, but not executed, because the component stopped or its client is gone
  kQueued,    ///< accepted; whether it was executed is not known
};

template <>
inline constexpr auto kPayload<CallOutcome> = DescribeEnum(
    "tendon.CallOutcome", Enumerator{"executed", CallOutcome::kExecuted},
    Enumerator{"failed", CallOutcome::kFailed}, Enumerator{"refused", CallOutcome::kRefused},
    Enumerator{"expired", CallOutcome::kExpired}, Enumerator{"dropped", CallOutcome::kDropped},
    Enumerator{"queued", CallOutcome::kQueued});

template <>
inline constexpr auto kPayload<Status::Code> = DescribeEnum(
    "tendon.Status", Enumerator{"done", Status::kDone}, Enumerator{"queued", Status::kQueued},
    Enumerator{"not_connected", Status::kNotConnected},
    Enumerator{"not_active", Status::kNotActive}, Enumerator{"queue_full", Status::kQueueFull},
    Enumerator{"no_sample", Status::kNoSample}, Enumerator{"timeout", Status::kTimeout},
    Enumerator{"outcome_unknown", Status::kOutcomeUnknown},
    Enumerator{"would_deadlock", Status::kWouldDeadlock}, Enumerator{"denied", Status::kDenied},
    Enumerator{"disabled", Status::kDisabled}, Enumerator{"unsupported", Status::kUnsupported},
    Enumerator{"invalid", Status::kInvalid}, Enumerator{"failed", Status::kFailed});

/// Returns true if the component's code ran, or will probably run.
[[nodiscard]] constexpr bool WasExecuted(CallOutcome outcome) noexcept {
  return outcome == CallOutcome::kExecuted || outcome == CallOutcome::kFailed ||
         outcome == CallOutcome::kQueued;
}

/// The beginning of an observed call. It takes 16 bytes on the wire, so the argument after it has
/// the alignment that it would have at the start of a body.
struct CallHeader {
  std::chrono::nanoseconds took{0};  ///< from the start of the execution to its end
  CallOutcome outcome = CallOutcome::kExecuted;
  Status::Code status = Status::kDone;  ///< why the call was not executed
};

template <>
inline constexpr auto kPayload<CallHeader> = Describe("tendon.CallHeader",
                                                      Field{"took", &CallHeader::took},
                                                      Field{"outcome", &CallHeader::outcome},
                                                      Field{"status", &CallHeader::status});

/// Returns true if the calls of a command with this signature can be observed. Reads change nothing
/// and may be called in every cycle, so they cannot be observed.
[[nodiscard]] constexpr bool CanBeObserved(const Signature& command) noexcept {
  return command.kind != CommandKind::kRead && command.kind != CommandKind::kQualifiedRead;
}

/// Describes the handler that receives the calls of `command`: a write with the types of the
/// argument and the result of the command.
[[nodiscard]] MemberDescription DescribeCalls(MemberDescription command);

/// Returns the type of an observed call. Its fields are those of CallHeader, then `argument` and
/// `result` if the command has them, then `client`, the required interface of the caller.
[[nodiscard]] Schema SchemaOfCalls(const Schema& argument, const Schema& result);

/// Return the argument and the result type from a schema that SchemaOfCalls() has returned; the
/// schema of None if `calls` has no such field.
[[nodiscard]] Schema ArgumentOfCalls(const Schema& calls);
[[nodiscard]] Schema ResultOfCalls(const Schema& calls);

/// Reads the header of an observed call, which may be untrusted: `took` is limited to the range
/// from 0 to one day. Returns a default-constructed header if the value cannot be read.
[[nodiscard]] CallHeader HeaderOfCall(std::span<const std::byte> call);

/// Encodes an observed call. If `out` is null, the result is the default of its type. All arguments
/// must outlive this object.
template <Payload In, Payload Out>
class ObservedCallWriter final : public ArgumentWriter {
 public:
  ObservedCallWriter(const CallHeader& header, const In& in, const Out* out,
                     const std::string& client)
      : header_(header), in_(in), out_(out != nullptr ? *out : kNoResult), client_(client) {}

  [[nodiscard]] std::size_t size() const override {
    std::size_t end = kEncodedSize<CallHeader>;
    if constexpr (kHasArgument) end = payload::EndOf(in_, end);
    if constexpr (kHasResult) end = payload::EndOf(out_, end);
    return payload::EndOf(client_, end);
  }
  [[nodiscard]] bool WriteTo(std::span<std::byte> place) const override {
    if (place.size() != size()) return false;
    payload::CdrWriter writer(place.data());
    payload::Write(writer, header_);
    if constexpr (kHasArgument) payload::Write(writer, in_);
    if constexpr (kHasResult) payload::Write(writer, out_);
    payload::Write(writer, client_);
    return writer.position() == place.size();
  }
  [[nodiscard]] std::span<const std::byte> Encoded() const override {
    encoded_.resize(size());
    return WriteTo(encoded_) ? std::span<const std::byte>(encoded_) : std::span<const std::byte>();
  }

 private:
  static constexpr bool kHasArgument = !std::is_same_v<In, None>;
  static constexpr bool kHasResult = !std::is_same_v<Out, None>;
  // Created before the first call, because a call must not allocate.
  static inline const Out kNoResult{};

  const CallHeader& header_;
  const In& in_;
  const Out& out_;
  const std::string& client_;
  mutable std::vector<std::byte> encoded_;
};

}  // namespace tendon
