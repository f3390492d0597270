#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/event_sink.h>

#include <string>
#include <vector>

namespace console {

/// The events that match any of `patterns`, in the catalogue's order, grouped by interface. A
/// pattern names an interface or an event and may contain `*` and `**`.
std::vector<tendon::EventSubscription> MatchingEvents(const tendon::Catalogue& catalogue,
                                                      const std::vector<std::string>& patterns);

/// Fails if a pattern matches no event: kNotFound suggests similar names; kInvalid if the pattern
/// matches something else, which the error names.
tendon::Result<void> CheckEventPatterns(const tendon::Catalogue& catalogue,
                                        const std::vector<std::string>& patterns);

}  // namespace console
