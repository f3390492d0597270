#pragma once

#include <tendon/middleware/frame.h>

#include <cstddef>
#include <span>
#include <string>

namespace tendon {

/// The object of a request to a GCM, for the audit log: "start robot/arm". The body is untrusted
/// and may be malformed; empty if there is no text.
[[nodiscard]] std::string AuditObject(MessageType type, std::span<const std::byte> body);

}  // namespace tendon
