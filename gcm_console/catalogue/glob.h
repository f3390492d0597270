#pragma once

#include <gcm_console/catalogue/system_items.h>
#include <tendon/base/result.h>

#include <string>
#include <vector>

namespace console {

/// Returns true if the path contains a `*`, so that it may match several objects.
[[nodiscard]] bool IsGlob(const std::string& path);

/// Returns all objects that the glob matches, in the order of the catalogue; kNotFound if there are
/// none.
tendon::Result<std::vector<SystemItem>> MatchingItems(const tendon::Catalogue& catalogue,
                                                      const std::string& glob);

/// Returns the matches together with everything that they contain.
tendon::Result<std::vector<SystemItem>> MatchingItemsAndContents(const tendon::Catalogue& catalogue,
                                                                 const std::string& glob);

/// Returns the error for a verb that accepts only one path but got a glob. The text says how to
/// list the matches.
[[nodiscard]] tendon::Error NoGlobAllowed(const std::string& command, const std::string& glob);

}  // namespace console
