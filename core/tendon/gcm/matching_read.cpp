#include <tendon/gcm/lookup.h>
#include <tendon/gcm/matching_read.h>

#include <algorithm>
#include <string_view>

namespace tendon {
namespace {

/// The subject of a command name: "Gains" for "SetGains" and "GetGains".
std::string_view Subject(std::string_view name) {
  const bool has_verb = name.starts_with("Set") || name.starts_with("Get");
  return has_verb ? name.substr(3) : name;
}

bool IsStructure(const std::string& type) { return type.find('.') != std::string::npos; }

/// The read command that returns the whole argument; empty if there is none.
std::string WholeRead(const ProvidedDescription& of, const MemberDescription& command) {
  std::string found;
  for (const MemberDescription& one : of.commands) {
    const bool fits =
        one.signature.kind == CommandKind::kRead && one.signature.out == command.signature.in;
    if (!fits) continue;
    if (Subject(one.name) == Subject(command.name)) return one.name;
    // Numbers of one type are too common to match by type alone.
    if (found.empty() && IsStructure(command.in_type)) found = one.name;
  }
  return found;
}

}  // namespace

std::vector<MatchingRead> MatchingReads(const ProvidedDescription& of,
                                        const MemberDescription& command) {
  if (!TakesArgument(command.signature)) return {};
  std::vector<MatchingRead> reads;
  if (std::string whole = WholeRead(of, command); !whole.empty()) {
    reads.push_back({.name = std::move(whole), .type = command.signature.in});
  }
  if (!IsStructure(command.in_type)) return reads;
  for (const MemberDescription& one : of.commands) {
    const bool may_have_some = one.signature.kind == CommandKind::kRead &&
                               one.signature.out != command.signature.in &&
                               IsStructure(one.out_type);
    if (!may_have_some) continue;
    reads.push_back({.name = one.name, .type = one.signature.out, .is_whole = false});
  }
  return reads;
}

}  // namespace tendon
