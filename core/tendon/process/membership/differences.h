#pragma once

#include <tendon/process/process_description.h>

#include <vector>

namespace tendon {

/// The data that a process reports to a GCM.
struct ProcessContent {
  std::vector<ComponentDescription> components;
  std::vector<ConnectionDescription> connections;
  std::vector<PluginDescription> plugins{};

  bool operator==(const ProcessContent&) const = default;
};

/// The changes from `before` to `after`, without changes of the process itself, in a valid order.
/// Revisions and process names are left empty. Components must have unique names, connections
/// unique ids.
[[nodiscard]] std::vector<CatalogueChange> Differences(const ProcessContent& before,
                                                       const ProcessContent& after);

}  // namespace tendon
