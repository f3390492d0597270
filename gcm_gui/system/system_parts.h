#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/system_file.h>

#include <string>

namespace tendon::gui {

/// Returns `base` with one item replaced by the item of `from`. If `from` does not have the item,
/// it is removed. `what` names the item as in SystemDifference: "component robot/arm".
[[nodiscard]] SystemFile WithPartOf(SystemFile base, const SystemFile& from,
                                    const std::string& what);

/// Returns the running system, including the connections of which the other interface does not
/// exist now.
[[nodiscard]] SystemFile WholeSystem(const Catalogue& catalogue);

}  // namespace tendon::gui
