#include <tendon/process/membership/differences.h>

#include <map>
#include <string>

namespace tendon {
namespace {

using ChangeKind = CatalogueChange::Kind;

template <typename Key, typename Description>
std::map<Key, const Description*> ByKey(const std::vector<Description>& descriptions,
                                        Key Description::*key) {
  std::map<Key, const Description*> by_key;
  for (const Description& one : descriptions) by_key[one.*key] = &one;
  return by_key;
}

/// Calls `removed(key)` for each removed element, and `changed(description)` for each new or
/// changed one.
template <typename Key, typename Description, typename Removed, typename Changed>
void CompareMaps(const std::map<Key, const Description*>& before,
                 const std::map<Key, const Description*>& after, Removed removed, Changed changed) {
  for (const auto& [key, description] : before) {
    if (!after.contains(key)) removed(key);
  }
  for (const auto& [key, description] : after) {
    const auto found = before.find(key);
    if (found == before.end() || *found->second != *description) changed(*description);
  }
}

CatalogueChange ChangeOf(ChangeKind kind) {
  CatalogueChange change;
  change.kind = kind;
  return change;
}

}  // namespace

std::vector<CatalogueChange> Differences(const ProcessContent& before,
                                         const ProcessContent& after) {
  std::vector<CatalogueChange> gone;
  std::vector<CatalogueChange> there;
  CompareMaps(
      ByKey(before.components, &ComponentDescription::name),
      ByKey(after.components, &ComponentDescription::name),
      [&](const std::string& name) {
        gone.push_back(ChangeOf(ChangeKind::kComponentRemoved));
        gone.back().component = name;
      },
      [&](const ComponentDescription& component) {
        there.push_back(ChangeOf(ChangeKind::kComponent));
        there.back().components = {component};
      });
  std::vector<CatalogueChange> changes;  // begins with removed connections
  CompareMaps(
      ByKey(before.connections, &ConnectionDescription::id),
      ByKey(after.connections, &ConnectionDescription::id),
      [&](std::uint64_t id) {
        changes.push_back(ChangeOf(ChangeKind::kConnectionRemoved));
        changes.back().connection = id;
      },
      [&](const ConnectionDescription& connection) {
        there.push_back(ChangeOf(ChangeKind::kConnection));
        there.back().connections = {connection};
      });
  changes.insert(changes.end(), gone.begin(), gone.end());
  changes.insert(changes.end(), there.begin(), there.end());
  return changes;
}

}  // namespace tendon
