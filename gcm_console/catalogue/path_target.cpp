#include <gcm_console/catalogue/path_target.h>

#include <tendon/base/path.h>
#include <tendon/gcm/lookup.h>

#include <vector>

namespace console {
namespace {

using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

Result<void> FindInterface(const std::string& owner, const std::string& name, PathTarget& target) {
  std::vector<std::string> known;
  for (const auto& one : target.component->provided) {
    known.push_back(one.name);
    if (one.name == name) target.provided = &one;
  }
  for (const auto& one : target.component->required) {
    known.push_back(one.name);
    if (one.name == name) target.required = &one;
  }
  if (target.provided != nullptr || target.required != nullptr) return {};
  return Error{ErrorCode::kNotFound,
               "no interface '" + owner + "/" + name + "'" + tendon::DidYouMean(name, known)};
}

Result<void> FindMember(const tendon::Path& path, PathTarget& target) {
  std::vector<std::string> known;
  const auto look = [&](const std::string& noun, const auto& members) {
    for (const auto& one : members) {
      known.push_back(one.name);
      if (one.name != path.member) continue;
      target.member = &one;
      target.noun = noun;
    }
  };
  if (target.provided != nullptr) {
    look("command", target.provided->commands);
    look("event", target.provided->events);
  } else {
    look("function", target.required->functions);
    look("handler", target.required->event_handlers);
  }
  if (target.member != nullptr) return {};
  return Error{ErrorCode::kNotFound, "no member '" + ToString(path.interface_name()) + "." +
                                         path.member + "'" +
                                         tendon::DidYouMean(path.member, known)};
}

}  // namespace

Result<PathTarget> FindTarget(const tendon::Catalogue& catalogue, const std::string& text) {
  const auto path = tendon::ParsePath(text);
  if (!path) return path.error();
  if (!path->field.empty()) {
    return Error{ErrorCode::kInvalid,
                 "'" + text + "' names a part of a value; to read this part: gcm get " + text};
  }
  PathTarget target;
  const auto process = LookUpProcess(catalogue, path->process);
  if (!process) return process.error();
  target.process = *process;
  if (path->component.empty()) return target;
  const auto component = LookUpComponent(catalogue, path->process, path->component);
  if (!component) return component.error();
  target.component = *component;
  if (path->interface.empty()) return target;
  const std::string owner = path->process + "/" + path->component;
  if (auto found = FindInterface(owner, path->interface, target); !found) return found.error();
  if (path->member.empty()) return target;
  if (auto found = FindMember(*path, target); !found) return found.error();
  return target;
}

std::string TypesOf(const tendon::MemberDescription& member) {
  const std::string in = TakesArgument(member.signature) ? member.in_type : "";
  const std::string out = HasResult(member) ? member.out_type : "";
  return in + (in.empty() || out.empty() ? "" : " -> ") + out;
}

bool HasResult(const tendon::MemberDescription& member) {
  return member.signature.out != tendon::FingerprintOf<tendon::None>();
}

}  // namespace console
