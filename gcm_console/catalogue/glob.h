#pragma once

#include <gcm_console/catalogue/things.h>
#include <tendon/base/result.h>

#include <string>
#include <vector>

namespace console {

/// Whether a path may name several things, by a `*`.
[[nodiscard]] bool IsGlob(const std::string& path);

/// All that a glob names, in the catalogue's order. kNotFound where that is nothing.
tendon::Result<std::vector<Thing>> ThingsThatFit(const tendon::Catalog& catalog,
                                                 const std::string& glob);

/// The same, with all that is in those.
tendon::Result<std::vector<Thing>> ThingsThatFitOrAreInside(const tendon::Catalog& catalog,
                                                            const std::string& glob);

/// For a verb that takes one thing and was given a glob: how to see what that names.
[[nodiscard]] tendon::Error TakesOneName(const std::string& command, const std::string& glob);

}  // namespace console
