#pragma once

#include <gcm_console/context.h>
#include <gcm_console/place.h>
#include <gcm_console/report.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/manager/component_description.h>

#include <nlohmann/json.hpp>
#include <optional>
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

// Each of these waits for an answer, at most --timeout.

/// The health of all processes; empty if the GCM does not provide it, which is not an error.
[[nodiscard]] tendon::message::SystemHealth AskHealth(Context& context);

/// The counters of the place's required interface, from its process. Empty if it is not connected
/// or the process does not answer.
[[nodiscard]] std::optional<tendon::ConnectionCounts> AskCounts(Context& context,
                                                                const Place& place);

/// The mailbox level of the component; empty without a mailbox or an answer of its process.
[[nodiscard]] std::optional<tendon::MailboxFill> AskFill(Context& context, const Place& place);

}  // namespace console
