#include <tendon/interface/compatibility.h>

#include <tendon/payload/schema.h>

#include <algorithm>

namespace tendon {
namespace {

/// Returns for example "write command 'MoveTo' of arm.JointGoal".
std::string Words(const MemberDescription& member, const std::string& noun) {
  std::string words =
      std::string(ToString(member.signature.kind)) + " " + noun + " '" + member.name + "'";
  switch (member.signature.kind) {
    case CommandKind::kVoid:
      return words;
    case CommandKind::kWrite:
      return words + " of " + member.in_type;
    case CommandKind::kRead:
    case CommandKind::kVoidReturn:
      return words + " of " + member.out_type;
    case CommandKind::kQualifiedRead:
    case CommandKind::kWriteReturn:
      return words + " of " + member.in_type + " -> " + member.out_type;
  }
  return words;
}

/// Describes how two types of the same name differ.
std::string DifferenceWords(Fingerprint needed, Fingerprint offered, const SchemaLookup& find) {
  const auto needed_schema = find(needed);
  const auto offered_schema = find(offered);
  if (needed_schema && offered_schema) {
    if (const auto first = FirstDifference(*needed_schema, *offered_schema)) return *first;
  }
  return "fields, units or shapes differ";
}

/// Describes the offered member, with only the words that show the difference.
std::string OfferedWords(const MemberDescription& needed, const MemberDescription& offered,
                         const SchemaLookup& find) {
  if (needed.signature.kind != offered.signature.kind) {
    return "a " + std::string(ToString(offered.signature.kind)) + " one";
  }
  const bool other_in = needed.signature.in != offered.signature.in;
  const std::string& type = other_in ? offered.in_type : offered.out_type;
  if (type != (other_in ? needed.in_type : needed.out_type)) return type;
  return "another " + type + " (" +
         (other_in ? DifferenceWords(needed.signature.in, offered.signature.in, find)
                   : DifferenceWords(needed.signature.out, offered.signature.out, find)) +
         ")";
}

void CompareMembers(const std::vector<MemberDescription>& needed,
                    const std::vector<MemberDescription>& offered, const std::string& noun,
                    const SchemaLookup& find, Compatibility& result) {
  for (const MemberDescription& member : needed) {
    if (!member.optional) ++result.needed;
    const auto found =
        std::find_if(offered.begin(), offered.end(),
                     [&member](const MemberDescription& one) { return one.name == member.name; });
    if (found == offered.end()) {
      if (member.optional) continue;
      result.mismatches.push_back(
          {Mismatch::Kind::kMissing, member.name, "missing " + Words(member, noun)});
    } else if (found->signature == member.signature) {
      if (!member.optional) ++result.matched;
    } else {
      const auto kind = found->signature.kind == member.signature.kind ? Mismatch::Kind::kOtherType
                                                                       : Mismatch::Kind::kOtherKind;
      result.mismatches.push_back({kind, member.name,
                                   "needs " + Words(member, noun) + ", but the provider offers " +
                                       OfferedWords(member, *found, find)});
    }
  }
}

}  // namespace

std::string Compatibility::Text() const {
  std::string text;
  for (const Mismatch& mismatch : mismatches) {
    if (!text.empty()) text += "; ";
    text += mismatch.text;
  }
  return text;
}

Compatibility Compare(const RequiredDescription& required, const ProvidedDescription& provided,
                      const SchemaLookup& find) {
  Compatibility result;
  CompareMembers(required.functions, provided.commands, "command", find, result);
  CompareMembers(required.event_handlers, provided.events, "event", find, result);
  return result;
}

std::string Refusal(const std::string& required, const std::string& provided,
                    const Compatibility& compatibility) {
  return required + " does not fit " + provided + ": " + compatibility.Text();
}

}  // namespace tendon
