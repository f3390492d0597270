#pragma once

#include <gcm_console/catalogue/path_target.h>
#include <gcm_console/context.h>
#include <gcm_console/output/table.h>
#include <tendon/gcm/catalogue.h>

#include <nlohmann/json.hpp>
#include <string>

/// The list of contents and the details of an object, for `ls` and `show`.
namespace console {

/// Returns one line for each part of the target.
[[nodiscard]] Table ListingOf(const tendon::Catalogue& catalogue, const PathTarget& target);

/// Returns everything about the target as JSON. Details that are not in the catalogue are requested
/// from its process or from the GCM.
[[nodiscard]] nlohmann::ordered_json JsonOf(Context& context, const tendon::Catalogue& catalogue,
                                            const PathTarget& target);

/// Formats a time: "62.5 ms", "2.5 s". Uses milliseconds below one second, and four significant
/// digits.
[[nodiscard]] std::string ExpiryText(double seconds);

}  // namespace console
