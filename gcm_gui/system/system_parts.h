#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/system_file.h>

#include <string>

namespace tendon::gui {

/// Returns `base` with one item replaced by the same item of `from`. If `from` does not have the
/// item, removes the item. `what` names the item as in SystemDifference: "component robot/arm".
[[nodiscard]] SystemFile WithPartOf(SystemFile base, const SystemFile& from,
                                    const std::string& what);

/// Returns the running system. A connection is included even if one of its interfaces does not
/// exist now.
[[nodiscard]] SystemFile WholeSystem(const Catalogue& catalogue);

}  // namespace tendon::gui
