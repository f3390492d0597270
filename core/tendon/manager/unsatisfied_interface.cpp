#include <tendon/manager/unsatisfied_interface.h>

#include <algorithm>

namespace tendon {
namespace {

bool HasNeededMember(const std::vector<MemberDescription>& members) {
  return std::ranges::any_of(members, [](const auto& member) { return !member.optional; });
}

std::string WaitReason(const ConnectionDescription* connection) {
  if (connection == nullptr) return "not connected";
  return std::string(ToString(connection->state)) +
         (connection->reason.empty() ? "" : ": " + connection->reason);
}

}  // namespace

bool IsNeeded(const RequiredDescription& required) {
  return !required.optional &&
         (HasNeededMember(required.functions) || HasNeededMember(required.event_handlers));
}

std::vector<UnsatisfiedInterface> UnmetNeedsOf(const ComponentDescription& component,
                                               const FindConnection& find) {
  std::vector<UnsatisfiedInterface> needs;
  for (const RequiredDescription& required : component.required) {
    if (!IsNeeded(required)) continue;
    const ConnectionDescription* connection = find(required.name);
    if (connection != nullptr && connection->state == ConnectionState::kActive) continue;
    needs.push_back({.interface = required.name,
                     .reason = WaitReason(connection),
                     .has_connection = connection != nullptr});
  }
  return needs;
}

std::vector<UnsatisfiedInterface> UnmetNeedsOf(
    const ComponentDescription& component, const std::vector<ConnectionDescription>& connections) {
  return UnmetNeedsOf(component, [&](const std::string& interface) {
    const auto found = std::ranges::find_if(connections, [&](const auto& one) {
      return one.required.component == component.name && one.required.interface == interface;
    });
    return found == connections.end() ? nullptr : &*found;
  });
}

std::string NamesOf(const std::vector<UnsatisfiedInterface>& needs) {
  std::string names;
  for (const UnsatisfiedInterface& need : needs)
    names += (names.empty() ? "" : ", ") + need.interface;
  return names;
}

std::string ReasonsOf(const std::vector<UnsatisfiedInterface>& needs) {
  std::string reasons;
  for (const UnsatisfiedInterface& need : needs) {
    reasons += (reasons.empty() ? "" : "; ") + need.interface + ": " + need.reason;
  }
  return reasons;
}

Result<void> CheckNeeds(const std::string& component,
                        const std::vector<UnsatisfiedInterface>& needs) {
  if (needs.empty()) return {};
  return Error{ErrorCode::kFailed, "component '" + component +
                                       "' is not started, because it would wait for " +
                                       ReasonsOf(needs) + "; make these connections first"};
}

}  // namespace tendon
