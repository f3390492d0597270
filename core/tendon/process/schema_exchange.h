#pragma once

#include <tendon/middleware/responder.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/process/messages.h>

#include <map>
#include <span>

namespace tendon {

/// Answers kGetSchemas with what this process knows. Refuses a question for more than 1024.
void AnswerSchemas(std::span<const std::byte> body, Responder& responder);

/// The schemas in an answer of any origin, by their fingerprints: those that were asked for and
/// whose texts are what the fingerprints say.
[[nodiscard]] std::map<Fingerprint, Schema> ReadSchemas(const message::GetSchemas& asked,
                                                        const message::Schemas& answer);

}  // namespace tendon
