#include <gcm_console/catalogue/place.h>
#include <tendon/base/path.h>
#include <tendon/gcm/lookup.h>

#include <vector>

namespace console {
namespace {

using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

Result<void> FindInterface(const std::string& owner, const std::string& name, Place& place) {
  std::vector<std::string> known;
  for (const auto& one : place.component->provided) {
    known.push_back(one.name);
    if (one.name == name) place.provided = &one;
  }
  for (const auto& one : place.component->required) {
    known.push_back(one.name);
    if (one.name == name) place.required = &one;
  }
  if (place.provided != nullptr || place.required != nullptr) return {};
  return Error{ErrorCode::kNotFound,
               "no interface '" + owner + "/" + name + "'" + tendon::DidYouMean(name, known)};
}

Result<void> FindMember(const tendon::Path& path, Place& place) {
  std::vector<std::string> known;
  const auto look = [&](const std::string& noun, const auto& members) {
    for (const auto& one : members) {
      known.push_back(one.name);
      if (one.name != path.member) continue;
      place.member = &one;
      place.noun = noun;
    }
  };
  if (place.provided != nullptr) {
    look("command", place.provided->commands);
    look("event", place.provided->events);
  } else {
    look("function", place.required->functions);
    look("handler", place.required->event_handlers);
  }
  if (place.member != nullptr) return {};
  return Error{ErrorCode::kNotFound, "no member '" + ToString(path.interface_name()) + "." +
                                         path.member + "'" +
                                         tendon::DidYouMean(path.member, known)};
}

}  // namespace

Result<Place> FindPlace(const tendon::Catalogue& catalogue, const std::string& text) {
  const auto path = tendon::ParsePath(text);
  if (!path) return path.error();
  if (!path->field.empty()) {
    return Error{ErrorCode::kInvalid,
                 "'" + text + "' names a part of a value; read it with: gcm get " + text};
  }
  Place place;
  const auto process = LookUpProcess(catalogue, path->process);
  if (!process) return process.error();
  place.process = *process;
  if (path->component.empty()) return place;
  const auto component = LookUpComponent(catalogue, path->process, path->component);
  if (!component) return component.error();
  place.component = *component;
  if (path->interface.empty()) return place;
  const std::string owner = path->process + "/" + path->component;
  if (auto found = FindInterface(owner, path->interface, place); !found) return found.error();
  if (path->member.empty()) return place;
  if (auto found = FindMember(*path, place); !found) return found.error();
  return place;
}

std::string TypesOf(const tendon::MemberDescription& member) {
  const std::string in = TakesArgument(member.signature) ? member.in_type : "";
  const std::string out = GivesAnswer(member) ? member.out_type : "";
  return in + (in.empty() || out.empty() ? "" : " -> ") + out;
}

bool GivesAnswer(const tendon::MemberDescription& member) {
  return member.signature.out != tendon::FingerprintOf<tendon::None>();
}

}  // namespace console
