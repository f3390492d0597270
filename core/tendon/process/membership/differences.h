#pragma once

#include <tendon/process/description.h>

#include <vector>

namespace tendon {

/// What a process tells a GCM of itself.
struct ProcessContent {
  std::vector<ComponentDescription> components;
  std::vector<ConnectionDescription> connections;
  std::vector<PluginDescription> plugins{};

  bool operator==(const ProcessContent&) const = default;
};

/// The steps from one to the other, without those of the process itself, in an order in which each
/// makes sense; their revisions and process names are empty. No two components, and no two
/// connections, of one name or id.
[[nodiscard]] std::vector<CatalogChange> Differences(const ProcessContent& before,
                                                     const ProcessContent& after);

}  // namespace tendon
