#include <tendon/process/version_messages.h>

#include <tendon/base/text.h>
#include <tendon/security/rights.h>

#include <string_view>

namespace tendon {

message::ProgramVersion OwnVersion() {
  return {.release = TENDON_VERSION, .protocol = FrameHeader::kProtocolVersion};
}

Error ExplainFailure(Error failure, MessageType request, const std::string& peer) {
  constexpr std::string_view kUnknownOutcome = "; outcome unknown";
  const std::string message = "message " + std::to_string(static_cast<unsigned>(request));
  // The texts with which GuardedHandler and ChannelHandler refuse an unknown message.
  const bool is_unknown = failure.message == message + " is not allowed for any role" ||
                          failure.message == message + " is not understood here";
  const Right* const right = FindRight(static_cast<std::uint16_t>(request));
  if (right == nullptr) return failure;
  if (right->role == Role::kViewer && failure.message.ends_with(kUnknownOutcome)) {
    failure.message.resize(failure.message.size() - kUnknownOutcome.size());
  }
  if (!is_unknown) return failure;
  failure.message = "process " + Quoted(peer, 64) + " does not know the request '" +
                    std::string(right->act) +
                    "', because it runs an older version of Tendon; start it again with " +
                    OwnVersion().release + " or later";
  return failure;
}

}  // namespace tendon
