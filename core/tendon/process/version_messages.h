#pragma once

#include <tendon/base/error.h>
#include <tendon/middleware/frame.h>
#include <tendon/payload/payload.h>

#include <cstdint>
#include <string>

/// The version of an LCM or a GCM.
namespace tendon::message {

// From a viewer.
inline constexpr auto kGetProgram =
    static_cast<MessageType>(0x20d);  // request: None -> ProgramVersion

/// The reply to kGetProgram.
struct ProgramVersion {
  std::string release;         ///< the release of Tendon: "0.4.0"
  std::uint16_t protocol = 0;  ///< the version of the protocol that the program uses
};

}  // namespace tendon::message

template <>
inline constexpr auto tendon::kPayload<tendon::message::ProgramVersion> = tendon::Describe(
    "tendon.ProgramVersion", tendon::Field{"release", &tendon::message::ProgramVersion::release},
    tendon::Field{"protocol", &tendon::message::ProgramVersion::protocol});

namespace tendon {

/// The version of this program.
[[nodiscard]] message::ProgramVersion OwnVersion();

/// Returns `failure`, the reason why a request to `peer` failed. If the peer does not know this
/// request, because it runs an older version of Tendon, the error says this and what to do. If a
/// viewer may send this request, it has no outcome, so the error does not call the outcome unknown.
[[nodiscard]] Error ExplainFailure(Error failure, MessageType request, const std::string& peer);

}  // namespace tendon
