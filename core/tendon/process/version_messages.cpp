#include <tendon/base/text.h>
#include <tendon/process/version_messages.h>
#include <tendon/security/rights.h>

#include <utility>

namespace tendon {

message::ProgramVersion OwnVersion() {
  return {.release = TENDON_VERSION, .protocol = FrameHeader::kProtocolVersion};
}

Error ExplainRefusal(Error refusal, MessageType request, const std::string& peer) {
  const std::string message = "message " + std::to_string(static_cast<unsigned>(request));
  // The texts with which GuardedHandler and ChannelHandler refuse an unknown message.
  const bool is_unknown = refusal.message == message + " is not allowed for any role" ||
                          refusal.message == message + " is not understood here";
  const Right* const right = FindRight(static_cast<std::uint16_t>(request));
  if (!is_unknown || right == nullptr) return refusal;
  refusal.message = "process " + Quoted(peer, 64) + " does not know the request '" +
                    std::string(right->act) +
                    "', because it runs an older version of Tendon; start it again with " +
                    OwnVersion().release + " or later";
  return refusal;
}

}  // namespace tendon
