#include <tendon/process/schema_exchange.h>

#include <algorithm>
#include <string>
#include <utility>

namespace tendon {

void AnswerSchemas(std::span<const std::byte> body, Responder& responder) {
  constexpr std::size_t kMost = 1024;
  const auto wanted = DecodeBody<message::GetSchemas>(body);
  if (!wanted) return responder.Refuse(wanted.error());
  if (wanted->fingerprints.size() > kMost) {
    return responder.Refuse(
        {ErrorCode::kInvalid, std::to_string(wanted->fingerprints.size()) +
                                  " schemas are wanted at once; ask for at most " +
                                  std::to_string(kMost)});
  }
  message::Schemas schemas;
  for (const Fingerprint& fingerprint : wanted->fingerprints) {
    const auto schema = FindSchema(fingerprint);
    schemas.texts.push_back(schema ? schema->TextWithHelp() : std::string());
  }
  responder.Reply(EncodeBody(schemas));
}

std::map<Fingerprint, Schema> ReadSchemas(const message::GetSchemas& asked,
                                          const message::Schemas& answer) {
  std::map<Fingerprint, Schema> schemas;
  const std::size_t count = std::min(asked.fingerprints.size(), answer.texts.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Fingerprint& fingerprint = asked.fingerprints[i];
    auto schema = Schema::Parse(answer.texts[i]);
    if (schema && schema->fingerprint() == fingerprint) {
      schemas.emplace(fingerprint, *std::move(schema));
    }
  }
  return schemas;
}

}  // namespace tendon
