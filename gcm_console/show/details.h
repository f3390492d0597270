#pragma once

#include <gcm_console/context.h>
#include <gcm_console/place.h>
#include <gcm_console/report.h>
#include <tendon/gcm/catalog.h>
#include <tendon/gcm/messages.h>
#include <tendon/manager/description.h>

#include <nlohmann/json.hpp>
#include <optional>

/// What is in a place, for `ls` and `show` alike.
namespace console {

/// A line for each thing that is in it.
[[nodiscard]] Table ListingOf(const tendon::Catalog& catalog, const Place& place);

/// All about it, with what its process or the GCM tells beside the catalogue.
[[nodiscard]] nlohmann::ordered_json JsonOf(Context& context, const tendon::Catalog& catalog,
                                            const Place& place);

// Each waits for an answer, as long as --timeout says.

/// Of all processes, as far as the GCM says: what is asked for is the catalogue.
[[nodiscard]] tendon::message::SystemHealth AskHealth(Context& context);

/// Of the place's required interface, as its process knows; nothing where it is not connected, or
/// the process does not tell.
[[nodiscard]] std::optional<tendon::ConnectionCounts> AskCounts(Context& context,
                                                                const Place& place);

/// Of the place's component; nothing where it has no mailbox, or its process does not tell.
[[nodiscard]] std::optional<tendon::MailboxFill> AskFill(Context& context, const Place& place);

}  // namespace console
