#include <gcm_gui/graph/layout/affinities.h>

#include <gcm_gui/models/text.h>
#include <tendon/interface/compatibility.h>

#include <map>
#include <set>
#include <string>
#include <tuple>

namespace tendon::gui {
namespace {

/// If a required interface fits more providers than this, these possible connections do not affect
/// the layout: they do not show where the client belongs.
constexpr std::size_t kMaxProviders = 3;

QString ComponentPath(const InterfaceName& name) {
  return ToQString(name.process + '/' + name.component);
}

/// Finds provided interfaces by a member, so that only a few interfaces must be compared.
class ProviderIndex {
 public:
  void Add(const InterfaceName& name, const ProvidedDescription& provided) {
    for (const auto& command : provided.commands)
      by_member_[Key(command)].push_back({name, &provided});
    for (const auto& event : provided.events) by_member_[Key(event)].push_back({name, &provided});
  }

  /// Returns the interfaces that fit `required`. Returns none if `required` needs no members,
  /// because then every interface would fit.
  [[nodiscard]] std::vector<InterfaceName> Fitting(const RequiredDescription& required) const {
    std::vector<InterfaceName> fitting;
    const MemberDescription* needed = FirstNeeded(required);
    if (needed == nullptr) return fitting;
    const auto it = by_member_.find(Key(*needed));
    if (it == by_member_.end()) return fitting;
    for (const auto& [name, provided] : it->second) {
      if (Compare(required, *provided).fits()) fitting.push_back(name);
      if (fitting.size() > kMaxProviders) return {};
    }
    return fitting;
  }

 private:
  struct Provider {
    InterfaceName name;
    const ProvidedDescription* description;
  };
  using MemberKey = std::tuple<std::string, Fingerprint, Fingerprint>;

  static MemberKey Key(const MemberDescription& member) {
    return {member.name, member.signature.in, member.signature.out};
  }

  static const MemberDescription* FirstNeeded(const RequiredDescription& required) {
    for (const auto* members : {&required.functions, &required.event_handlers}) {
      for (const auto& member : *members) {
        if (!member.optional) return &member;
      }
    }
    return nullptr;
  }

  std::map<MemberKey, std::vector<Provider>> by_member_;
};

}  // namespace

std::set<Affinity> FittingOf(const Catalogue& catalogue) {
  ProviderIndex providers;
  for (const auto& [process, entry] : catalogue.processes()) {
    for (const auto& [name, component] : entry.components) {
      for (const auto& provided : component.provided) {
        providers.Add({process, name, provided.name}, provided);
      }
    }
  }
  std::set<Affinity> affinities;
  for (const auto& [process, entry] : catalogue.processes()) {
    for (const auto& [name, component] : entry.components) {
      for (const auto& required : component.required) {
        const QString client = ToQString(process + '/' + name);
        for (const auto& fitting : providers.Fitting(required)) {
          affinities.insert({ComponentPath(fitting), client});
        }
      }
    }
  }
  return affinities;
}

std::vector<Affinity> AffinitiesOf(std::set<Affinity> fitting,
                                   const std::vector<ConnectionDescription>& edges) {
  for (const auto& edge : edges) {
    fitting.insert({ComponentPath(edge.provided), ComponentPath(edge.required)});
  }
  std::erase_if(fitting, [](const Affinity& a) { return a.provider == a.client; });
  return {fitting.begin(), fitting.end()};
}

}  // namespace tendon::gui
