#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>

#include <set>
#include <vector>

namespace tendon::gui {

/// Returns the pairs of components that could be connected, judged only by their interfaces. The
/// cost is linear in the number of members, and in the number of pairs of interfaces with the same
/// first member.
[[nodiscard]] std::set<Affinity> FittingOf(const Catalogue& catalogue);

/// Returns `fitting` together with the affinities of the connected components (`edges`), sorted.
[[nodiscard]] std::vector<Affinity> AffinitiesOf(std::set<Affinity> fitting,
                                                 const std::vector<ConnectionDescription>& edges);

}  // namespace tendon::gui
