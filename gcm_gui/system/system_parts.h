#pragma once

#include <tendon/gcm/catalog.h>
#include <tendon/gcm/system_file.h>

#include <string>

namespace tendon::gui {

/// `base`, in which one thing is as `from` has it: added, changed, or removed where `from` lacks
/// it. `what` is that of a SystemDifference: "component robot/arm".
[[nodiscard]] SystemFile WithPartOf(SystemFile base, const SystemFile& from,
                                    const std::string& what);

/// What runs, with what it is connected to that is not there now.
[[nodiscard]] SystemFile WholeSystem(const Catalog& catalogue);

}  // namespace tendon::gui
