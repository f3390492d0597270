#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>

#include <set>
#include <vector>

namespace tendon::gui {

/// Between components that could be connected: depends on their interfaces alone. Linear in
/// members, and in the pairs of interfaces that share their first member.
[[nodiscard]] std::set<Affinity> FittingOf(const Catalog& catalogue);

/// Between components that are connected (`edges`) or could be. Sorted.
[[nodiscard]] std::vector<Affinity> AffinitiesOf(std::set<Affinity> fitting,
                                                 const std::vector<ConnectionDescription>& edges);

}  // namespace tendon::gui
