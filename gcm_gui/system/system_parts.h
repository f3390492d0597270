#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/system_file.h>

#include <string>

namespace tendon::gui {

/// Returns `base` with one item replaced by that of `from`, or removed if `from` does not have it.
/// `what` names the item as SystemDifference does: "component robot/arm".
[[nodiscard]] SystemFile WithPartOf(SystemFile base, const SystemFile& from,
                                    const std::string& what);

/// The running system, including connections whose other end does not exist now.
[[nodiscard]] SystemFile WholeSystem(const Catalogue& catalogue);

}  // namespace tendon::gui
