#include <tendon/process/version_messages.h>

namespace tendon {

message::ProgramVersion OwnVersion() {
  return {.release = TENDON_VERSION, .protocol = FrameHeader::kProtocolVersion};
}

}  // namespace tendon
