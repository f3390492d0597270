#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>

#include <set>
#include <vector>

namespace tendon::gui {

/// The affinities between components that could be connected, from their interfaces alone. Linear
/// in the members, and in the pairs of interfaces that share their first member.
[[nodiscard]] std::set<Affinity> FittingOf(const Catalogue& catalogue);

/// Adds the affinities of connected components (`edges`) to `fitting`. Sorted.
[[nodiscard]] std::vector<Affinity> AffinitiesOf(std::set<Affinity> fitting,
                                                 const std::vector<ConnectionDescription>& edges);

}  // namespace tendon::gui
