#pragma once

#include <gcm_console/catalogue/path_target.h>
#include <gcm_console/context.h>
#include <gcm_console/output/table.h>
#include <tendon/gcm/catalogue.h>

#include <nlohmann/json.hpp>
#include <string>

/// The listing and the details of the target of a path, for `ls` and `show`.
namespace console {

/// One line for each part of the target.
[[nodiscard]] Table ListingOf(const tendon::Catalogue& catalogue, const PathTarget& target);

/// Everything about the target, with details from its process or the GCM that are not in the
/// catalogue.
[[nodiscard]] nlohmann::ordered_json JsonOf(Context& context, const tendon::Catalogue& catalogue,
                                            const PathTarget& target);

/// "62.5 ms", "2.5 s": milliseconds below one second, with four significant digits.
[[nodiscard]] std::string ExpiryText(double seconds);

}  // namespace console
