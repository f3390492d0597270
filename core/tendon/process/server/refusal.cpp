#include <tendon/interface/compatibility.h>
#include <tendon/process/ask.h>
#include <tendon/process/schema_exchange.h>
#include <tendon/process/server/refusal.h>

#include <algorithm>
#include <map>
#include <optional>

namespace tendon {
namespace {

constexpr std::chrono::milliseconds kAnswerTimeout(400);  // the opener waits meanwhile
constexpr std::size_t kMostTypes = 8;

/// Adds the incompatible types of `members` that this process does not know.
void AddUnknown(const std::vector<MemberDescription>& members, const Compatibility& compatibility,
                std::vector<Fingerprint>& unknown) {
  for (const Mismatch& mismatch : compatibility.mismatches) {
    if (mismatch.kind != Mismatch::Kind::kOtherType) continue;
    const auto member = std::find_if(members.begin(), members.end(),
                                     [&](const auto& one) { return one.name == mismatch.member; });
    if (member == members.end()) continue;
    for (const Fingerprint& type : {member->signature.in, member->signature.out}) {
      if (unknown.size() < kMostTypes && !FindSchema(type)) unknown.push_back(type);
    }
  }
}

Error Misfit(const message::OpenInterface& open, const ProvidedDescription& provided,
             const std::map<Fingerprint, Schema>& schemas) {
  const auto find = [&](Fingerprint type) -> std::optional<Schema> {
    const auto found = schemas.find(type);
    return found != schemas.end() ? found->second : FindSchema(type);
  };
  return {ErrorCode::kIncompatible, Refusal(ToString(open.required), ToString(open.provided),
                                            Compare(open.description, provided, find))};
}

}  // namespace

void RefuseMisfit(Worker& timer, const std::shared_ptr<Channel>& channel,
                  const message::OpenInterface& open, const ProvidedDescription& provided,
                  const Error& why, const std::shared_ptr<Responder>& responder) {
  const Compatibility compatibility = Compare(open.description, provided);
  message::GetSchemas unknown;
  AddUnknown(open.description.functions, compatibility, unknown.fingerprints);
  AddUnknown(open.description.event_handlers, compatibility, unknown.fingerprints);
  if (unknown.fingerprints.empty()) return responder->Refuse(why);
  Ask<message::Schemas>(timer, channel, message::kGetSchemas, unknown, kAnswerTimeout,
                        [open, provided, unknown, why, responder](const auto& known) {
                          if (!known) return responder->Refuse(why);
                          const auto schemas = ReadSchemas(unknown, *known);
                          responder->Refuse(Misfit(open, provided, schemas));
                        });
}

}  // namespace tendon
