#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalog.h>

#include <string>

namespace console {

/// Refuses two ends that stand in each other's place, and says how `verb` is to be called: nobody
/// who looks from the other side means something else.
tendon::Result<void> CheckOrder(const std::string& verb, const tendon::Catalog& catalog,
                                const tendon::InterfaceName& required,
                                const tendon::InterfaceName& provided);

}  // namespace console
