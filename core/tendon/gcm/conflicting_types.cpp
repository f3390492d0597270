#include <tendon/gcm/conflicting_types.h>

#include <tendon/gcm/lookup.h>

#include <string_view>

namespace tendon {
namespace {

/// All types by name, each with one process that knows it.
class TypesByName {
 public:
  void Add(const ComponentDescription& component, std::string_view process) {
    for (const ProvidedDescription& provided : component.provided) Add(provided, process);
    for (const RequiredDescription& required : component.required) Add(required, process);
  }
  void Add(const ProvidedDescription& provided, std::string_view process) {
    Add(provided.commands, process);
    Add(provided.events, process);
  }
  void Add(const RequiredDescription& required, std::string_view process) {
    Add(required.functions, process);
    Add(required.event_handlers, process);
  }

  [[nodiscard]] std::map<std::string, message::GetSchemas> Conflicting() const {
    std::map<std::string, message::GetSchemas> conflicting;
    for (const auto& [name, types] : types_) {
      if (types.size() < 2) continue;
      for (const auto& [type, process] : types) {
        if (FindSchema(type)) continue;
        conflicting[std::string(process)].fingerprints.push_back(type);
      }
    }
    return conflicting;
  }

 private:
  void Add(const std::vector<MemberDescription>& members, std::string_view process) {
    for (const MemberDescription& member : members) {
      Add(member.in_type, member.signature.in, process);
      Add(member.out_type, member.signature.out, process);
    }
  }
  void Add(const std::string& name, const Fingerprint& type, std::string_view process) {
    if (!name.empty()) types_[name].try_emplace(type, process);
  }

  // The views refer to strings in the catalogue.
  std::map<std::string_view, std::map<Fingerprint, std::string_view>> types_;
};

}  // namespace

std::map<std::string, message::GetSchemas> ConflictingTypes(const Catalogue& catalogue) {
  TypesByName types;
  for (const auto& [name, entry] : catalogue.processes()) {
    if (!IsPresent(entry.process)) continue;
    for (const auto& [component_name, component] : entry.components) types.Add(component, name);
  }
  return types.Conflicting();
}

std::map<std::string, message::GetSchemas> ConflictingTypesBetween(
    const Catalogue& catalogue, const message::ConnectionEnds& ends) {
  TypesByName types;
  if (const auto* required = catalogue.FindRequired(ends.required)) {
    types.Add(*required, ends.required.process);
  }
  if (const auto* provided = catalogue.FindProvided(ends.provided)) {
    types.Add(*provided, ends.provided.process);
  }
  return types.Conflicting();
}

}  // namespace tendon
