#pragma once

#include <gcm_console/catalogue/system_items.h>
#include <tendon/base/result.h>

#include <string>
#include <vector>

namespace console {

/// True if the path contains a `*` and so may name several things.
[[nodiscard]] bool IsGlob(const std::string& path);

/// All things that the glob matches, in the catalogue's order; kNotFound if there are none.
tendon::Result<std::vector<SystemItem>> MatchingItems(const tendon::Catalogue& catalogue,
                                                      const std::string& glob);

/// The same, with everything inside those things.
tendon::Result<std::vector<SystemItem>> MatchingItemsAndContents(const tendon::Catalogue& catalogue,
                                                                 const std::string& glob);

/// The error for a verb that takes one path and got a glob: its text says how to list the matches.
[[nodiscard]] tendon::Error NoGlobAllowed(const std::string& command, const std::string& glob);

}  // namespace console
