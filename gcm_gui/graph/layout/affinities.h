#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>

#include <vector>

namespace tendon::gui {

/// Between components that are connected (`edges`) or could be. Sorted. Linear in members, and in
/// the pairs of interfaces that share their first member.
[[nodiscard]] std::vector<Affinity> AffinitiesOf(const Catalog& catalogue,
                                                 const std::vector<ConnectionDescription>& edges);

}  // namespace tendon::gui
