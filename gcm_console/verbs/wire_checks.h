#pragma once

#include <gcm_console/context.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>

#include <string>

namespace console {

/// Returns an error if the two interfaces are in the wrong order (provided first, required second);
/// it says how to call `verb`. The wrong order can have no other meaning.
tendon::Result<void> CheckOrder(const std::string& verb, const tendon::Catalogue& catalogue,
                                const tendon::InterfaceName& required,
                                const tendon::InterfaceName& provided);

/// Requests the types that differ although they have the same name, so that an error can say how
/// two interfaces differ. Waits for each answer at most --timeout, and ignores failures.
void LearnConflictingTypes(Context& context);

}  // namespace console
