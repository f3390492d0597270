#pragma once

#include <gcm_console/catalogue/place.h>
#include <gcm_console/context.h>
#include <gcm_console/output/table.h>
#include <tendon/gcm/catalogue.h>

#include <nlohmann/json.hpp>
#include <string>

/// The content of a place, for `ls` and `show`.
namespace console {

/// One line for each thing inside the place.
[[nodiscard]] Table ListingOf(const tendon::Catalogue& catalogue, const Place& place);

/// Everything about the place, with details from its process or the GCM that are not in the
/// catalogue.
[[nodiscard]] nlohmann::ordered_json JsonOf(Context& context, const tendon::Catalogue& catalogue,
                                            const Place& place);

/// "62.5 ms", "2.5 s": milliseconds below one second, with four significant digits.
[[nodiscard]] std::string ExpiryText(double seconds);

}  // namespace console
