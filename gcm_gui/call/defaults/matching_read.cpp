#include <gcm_gui/call/matching_read.h>
#include <tendon/gcm/lookup.h>

#include <vector>

namespace tendon::gui {
namespace {

/// "Gains" of "SetGains" and "GetGains".
std::string_view Subject(std::string_view name) {
  const bool has_verb = name.starts_with("Set") || name.starts_with("Get");
  return has_verb ? name.substr(3) : name;
}

}  // namespace

std::string MatchingRead(const ProvidedDescription& of, const MemberDescription& command) {
  if (!TakesArgument(command.signature)) return {};
  std::string found;
  for (const MemberDescription& one : of.commands) {
    const bool fits =
        one.signature.kind == CommandKind::kRead && one.signature.out == command.signature.in;
    if (!fits) continue;
    if (Subject(one.name) == Subject(command.name)) return one.name;
    const bool is_structure = command.in_type.find('.') != std::string::npos;
    if (found.empty() && is_structure) found = one.name;  // any number is like any other
  }
  return found;
}

}  // namespace tendon::gui
