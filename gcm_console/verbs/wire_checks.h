#pragma once

#include <gcm_console/context.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>

#include <string>

namespace console {

/// Refuses swapped ends (provided first, required second) and says how to call `verb`. Swapped ends
/// can have no other meaning.
tendon::Result<void> CheckOrder(const std::string& verb, const tendon::Catalogue& catalogue,
                                const tendon::InterfaceName& required,
                                const tendon::InterfaceName& provided);

/// Asks the processes for types that differ under the same name, so that errors can name the
/// difference between two ends. Waits for each reply up to the usual time-out, and ignores
/// failures.
void LearnConflictingTypes(Context& context);

}  // namespace console
