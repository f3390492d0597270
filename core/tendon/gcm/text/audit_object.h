#pragma once

#include <tendon/middleware/frame.h>

#include <cstddef>
#include <span>
#include <string>

namespace tendon {

/// What a request to a GCM is about, for the audit log: "start robot/arm". Of a body from outside,
/// which may be malformed; empty where there is nothing to say.
[[nodiscard]] std::string AuditObject(MessageType type, std::span<const std::byte> body);

}  // namespace tendon
