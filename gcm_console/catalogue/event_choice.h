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

/// The commands that a pattern may match.
enum class CommandChoice {
  kNamed,  ///< the pattern is the full path of a command and selects only this command
  kAll,    ///< like events
};

/// Returns the commands that match any of `patterns`, as MatchingEvents() does. Leaves out reads,
/// because their calls cannot be observed.
std::vector<tendon::EventSubscription> MatchingCommands(const tendon::Catalogue& catalogue,
                                                        const std::vector<std::string>& patterns,
                                                        CommandChoice choice);

/// Returns an error if a pattern matches no event and no command. kNotFound suggests similar names.
/// kInvalid names the object that the pattern matches instead.
tendon::Result<void> CheckEventPatterns(const tendon::Catalogue& catalogue,
                                        const std::vector<std::string>& patterns,
                                        CommandChoice choice);

}  // namespace console
