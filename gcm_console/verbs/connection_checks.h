#pragma once

#include <gcm_console/context.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>

#include <string>

namespace console {

/// Returns an error if the provided interface is given first and the required interface second. The
/// error shows the correct command with `verb`. The wrong order can have no other meaning.
tendon::Result<void> CheckOrder(const std::string& verb, const tendon::Catalogue& catalogue,
                                const tendon::InterfaceName& required,
                                const tendon::InterfaceName& provided);

/// Requests the types that have the same name but differ, so that an error can describe the
/// difference between two interfaces. Waits for each answer at most --timeout, and ignores
/// failures.
void LearnConflictingTypes(Context& context);

}  // namespace console
