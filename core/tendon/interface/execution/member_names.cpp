#include <tendon/interface/execution/member_names.h>

#include <tendon/base/name.h>

namespace tendon {

void MemberNames::Add(const std::string& what, const std::string& name,
                      const std::string& interface, SourceLocation location) {
  RequireName(what, name);
  const std::string member = what + " '" + name + "'";
  if (sealed_) throw AddedTooLate(member, "interface '" + interface + "'");
  const auto [first, is_new] = added_at_.emplace(name, location);
  if (!is_new) {
    throw ConfigurationError(member + " already exists in interface '" + interface +
                             "' (added at " + ToString(first->second) + ")");
  }
}

}  // namespace tendon
