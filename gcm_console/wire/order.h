#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>

#include <string>

namespace console {

/// Refuses swapped ends (provided first, required second) and says how to call `verb`. Swapped ends
/// can have no other meaning.
tendon::Result<void> CheckOrder(const std::string& verb, const tendon::Catalogue& catalogue,
                                const tendon::InterfaceName& required,
                                const tendon::InterfaceName& provided);

}  // namespace console
