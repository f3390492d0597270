#include <tendon/process/schema_exchange.h>

#include <tendon/base/log.h>
#include <tendon/process/ask.h>

#include <algorithm>
#include <string>
#include <utility>

namespace tendon {
namespace {

SchemaCache& Learned() {
  static SchemaCache learned(SchemaCache::Limits{});
  return learned;
}

}  // namespace

void ReplyWithSchemas(std::span<const std::byte> body, Responder& responder) {
  constexpr std::size_t kMax = 1024;
  const auto wanted = DecodeBody<message::GetSchemas>(body);
  if (!wanted) return responder.Refuse(wanted.error());
  if (wanted->fingerprints.size() > kMax) {
    return responder.Refuse(
        {ErrorCode::kInvalid, std::to_string(wanted->fingerprints.size()) +
                                  " schemas are requested at once; ask for at most " +
                                  std::to_string(kMax)});
  }
  message::Schemas schemas;
  for (const Fingerprint& fingerprint : wanted->fingerprints) {
    const auto schema = FindSchema(fingerprint);
    schemas.texts.push_back(schema ? schema->TextWithHelp() : std::string());
  }
  responder.Reply(EncodeBody(schemas));
}

std::map<Fingerprint, Schema> ReadSchemas(const message::GetSchemas& asked,
                                          const message::Schemas& reply) {
  std::map<Fingerprint, Schema> schemas;
  const std::size_t count = std::min(asked.fingerprints.size(), reply.texts.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Fingerprint& fingerprint = asked.fingerprints[i];
    auto schema = Schema::Parse(reply.texts[i]);
    if (schema && schema->fingerprint() == fingerprint) {
      schemas.emplace(fingerprint, *std::move(schema));
    }
  }
  return schemas;
}

bool SchemaCache::Learn(const Schema& schema) {
  const std::scoped_lock lock(mutex_);
  if (FindSchema(schema.fingerprint())) return true;
  const std::size_t size = schema.TextWithHelp().size();
  if (types_ < limits_.types && size <= limits_.text - text_) {
    payload::Remember(schema);
    ++types_;
    text_ += size;
    return true;
  }
  if (!std::exchange(has_warned_, true)) {
    Log(LogLevel::kWarning, "types",
        "other processes have more types than this process can store (" + std::to_string(types_) +
            " types with " + std::to_string(text_) +
            " bytes of text); only the fingerprints of further types are known here");
  }
  return false;
}

void LearnSchemas(Worker& timer, const std::shared_ptr<Channel>& channel,
                  const message::GetSchemas& wanted, std::chrono::milliseconds timeout,
                  std::function<void()> done) {
  Ask<message::Schemas>(timer, channel, message::kGetSchemas, wanted, timeout,
                        [wanted, done = std::move(done)](const Result<message::Schemas>& reply) {
                          if (reply) {
                            for (const auto& [fingerprint, schema] : ReadSchemas(wanted, *reply)) {
                              (void)Learned().Learn(schema);
                            }
                          }
                          done();
                        });
}

}  // namespace tendon
