#include <tendon/gcm/interface_matching.h>

#include <tendon/gcm/lookup.h>
#include <tendon/interface/compatibility.h>

#include <algorithm>
#include <utility>

namespace tendon {
namespace {

/// Interfaces with their names. Select() lists the interfaces of present processes.
template <typename Description>
using Named = std::vector<std::pair<InterfaceName, const Description*>>;

template <typename Description>
Named<Description> Select(const Catalogue& catalogue, const std::string& pattern,
                          SharedList<Description> ComponentDescription::*interfaces) {
  Named<Description> selected;
  for (const auto& [process, entry] : catalogue.processes()) {
    if (!IsPresent(entry.process)) continue;
    for (const auto& [component, description] : entry.components) {
      for (const Description& interface : description.*interfaces) {
        InterfaceName name{process, component, interface.name};
        if (MatchesGlob(pattern, ToString(name))) selected.emplace_back(name, &interface);
      }
    }
  }
  return selected;
}

Error NoneIs(const std::string& kind, const std::string& pattern) {
  return {ErrorCode::kNotFound,
          "no " + kind + " interface matches '" + pattern + "'; to list all names: gcm ls -R"};
}

bool IsOfOneComponent(const InterfaceName& a, const InterfaceName& b) {
  return a.process == b.process && a.component == b.component;
}

Match MatchOf(const InterfaceName& name, const RequiredDescription& required,
              const Named<ProvidedDescription>& provided) {
  Match match{name, {}};
  for (const auto& [candidate, description] : provided) {
    if (!IsOfOneComponent(name, candidate) && Compare(required, *description).fits()) {
      match.provided.push_back(candidate);
    }
  }
  const auto has_other_name = [&](const InterfaceName& one) {
    return one.interface != name.interface;
  };
  if (!std::ranges::all_of(match.provided, has_other_name)) {
    std::erase_if(match.provided, has_other_name);
  }
  return match;
}

}  // namespace

Result<std::vector<Match>> MatchInterfaces(const Catalogue& catalogue,
                                           const MatchPatterns& patterns) {
  const auto required = Select(catalogue, patterns.required, &ComponentDescription::required);
  if (required.empty()) return NoneIs("required", patterns.required);
  const auto provided = Select(catalogue, patterns.provided, &ComponentDescription::provided);
  if (provided.empty()) return NoneIs("provided", patterns.provided);
  std::vector<Match> matches;
  for (const auto& [name, description] : required) {
    if (catalogue.FindConnection(name) != nullptr) continue;
    matches.push_back(MatchOf(name, *description, provided));
  }
  return matches;
}

}  // namespace tendon
