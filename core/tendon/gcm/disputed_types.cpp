#include <tendon/gcm/disputed_types.h>
#include <tendon/gcm/lookup.h>

#include <string_view>

namespace tendon {
namespace {

/// All types by name, and where one who knows each is found.
class TypesByName {
 public:
  void Add(const ComponentDescription& component, const std::string& process) {
    for (const ProvidedDescription& provided : component.provided) Add(provided, process);
    for (const RequiredDescription& required : component.required) Add(required, process);
  }
  void Add(const ProvidedDescription& provided, const std::string& process) {
    Add(provided.commands, process);
    Add(provided.events, process);
  }
  void Add(const RequiredDescription& required, const std::string& process) {
    Add(required.functions, process);
    Add(required.event_handlers, process);
  }

  [[nodiscard]] std::map<std::string, message::GetSchemas> Disputed() const {
    std::map<std::string, message::GetSchemas> disputed;
    for (const auto& [name, types] : types_) {
      if (types.size() < 2) continue;
      for (const auto& [type, process] : types) {
        if (!FindSchema(type)) disputed[process].fingerprints.push_back(type);
      }
    }
    return disputed;
  }

 private:
  void Add(const std::vector<MemberDescription>& members, const std::string& process) {
    for (const MemberDescription& member : members) {
      if (!member.in_type.empty()) types_[member.in_type].emplace(member.signature.in, process);
      if (!member.out_type.empty()) types_[member.out_type].emplace(member.signature.out, process);
    }
  }

  std::map<std::string_view, std::map<Fingerprint, std::string>> types_;
};

}  // namespace

std::map<std::string, message::GetSchemas> DisputedTypes(const Catalog& catalog) {
  TypesByName types;
  for (const auto& [name, entry] : catalog.processes()) {
    if (!IsPresent(entry.process)) continue;
    for (const auto& [component_name, component] : entry.components) types.Add(component, name);
  }
  return types.Disputed();
}

std::map<std::string, message::GetSchemas> DisputedTypesBetween(const Catalog& catalog,
                                                                const message::Wire& wire) {
  TypesByName types;
  if (const auto* required = catalog.FindRequired(wire.required)) {
    types.Add(*required, wire.required.process);
  }
  if (const auto* provided = catalog.FindProvided(wire.provided)) {
    types.Add(*provided, wire.provided.process);
  }
  return types.Disputed();
}

}  // namespace tendon
