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

/// Returns the changes from `before` to `after`, in a valid order. Does not include changes of the
/// process itself. Leaves revisions and process names empty. Components must have unique names, and
/// connections unique ids.
[[nodiscard]] std::vector<CatalogueChange> Differences(const ProcessContent& before,
                                                       const ProcessContent& after);

}  // namespace tendon
