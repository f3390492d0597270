#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/event_sink.h>

#include <string>
#include <vector>

namespace console {

/// Returns the events that match any of `patterns`, grouped by interface, in the order of the
/// catalogue. A pattern names an interface or an event, and may contain `*` and `**`.
std::vector<tendon::EventSubscription> MatchingEvents(const tendon::Catalogue& catalogue,
                                                      const std::vector<std::string>& patterns);

/// Returns an error if a pattern matches no event. kNotFound suggests similar names. kInvalid names
/// the object that the pattern matches instead of an event.
tendon::Result<void> CheckEventPatterns(const tendon::Catalogue& catalogue,
                                        const std::vector<std::string>& patterns);

}  // namespace console
