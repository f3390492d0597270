#include <gcm_console/catalogue/event_choice.h>

#include <gcm_console/catalogue/path_target.h>
#include <tendon/base/path.h>
#include <tendon/interface/observed_call.h>

#include <algorithm>

namespace console {
namespace {

using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

bool FitsAny(const std::vector<std::string>& patterns, const std::string& text) {
  return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
    return tendon::MatchesGlob(pattern, text);
  });
}

/// Returns the reason why a pattern matches no event.
Error Misfit(const tendon::Catalogue& catalogue, const std::string& pattern) {
  if (pattern.find('*') != std::string::npos) {
    return {ErrorCode::kNotFound,
            "no event matches '" + pattern + "'; to list all events: gcm ls -R --type event"};
  }
  const auto target = FindTarget(catalogue, pattern);
  if (!target) return target.error();
  if (target->member != nullptr && target->provided != nullptr && target->noun == "command") {
    return {ErrorCode::kInvalid, "'" + pattern +
                                     "' is a read command: only calls of other commands can be "
                                     "watched"};
  }
  if (target->member != nullptr) {
    return {ErrorCode::kInvalid, "'" + pattern + "' is a " + target->noun + ", not an event"};
  }
  if (target->required != nullptr) {
    return {ErrorCode::kInvalid, "'" + pattern +
                                     "' is a required interface: only a provided "
                                     "interface has events"};
  }
  if (target->provided != nullptr) {
    return {ErrorCode::kNotFound, "'" + pattern + "' has no events"};
  }
  return {ErrorCode::kInvalid, "'" + pattern +
                                   "' is not an interface: give the path of one interface; or, for "
                                   "all interfaces in it, give '" +
                                   pattern + "/**'"};
}

/// Runs `choose(provided, path, subscription)` for each provided interface, and returns the
/// subscriptions that are not empty.
template <typename Choose>
std::vector<tendon::EventSubscription> Matching(const tendon::Catalogue& catalogue, Choose choose) {
  std::vector<tendon::EventSubscription> all;
  for (const auto& [process, entry] : catalogue.processes()) {
    for (const auto& [component, description] : entry.components) {
      for (const auto& provided : description.provided) {
        tendon::EventSubscription one{.provided = {process, component, provided.name},
                                      .events = {}};
        choose(provided, ToString(one.provided), one);
        if (one.size() > 0) all.push_back(std::move(one));
      }
    }
  }
  return all;
}

}  // namespace

std::vector<tendon::EventSubscription> MatchingEvents(const tendon::Catalogue& catalogue,
                                                      const std::vector<std::string>& patterns) {
  return Matching(catalogue, [&](const auto& provided, const std::string& path, auto& one) {
    for (const auto& event : provided.events) {
      if (FitsAny(patterns, path) || FitsAny(patterns, path + "." + event.name)) {
        one.events.push_back(event.name);
      }
    }
  });
}

std::vector<tendon::EventSubscription> MatchingCommands(const tendon::Catalogue& catalogue,
                                                        const std::vector<std::string>& patterns,
                                                        CommandChoice choice) {
  return Matching(catalogue, [&](const auto& provided, const std::string& path, auto& one) {
    for (const auto& command : provided.commands) {
      const std::string full = path + "." + command.name;
      const bool is_wanted = choice == CommandChoice::kNamed
                                 ? std::ranges::count(patterns, full) > 0
                                 : FitsAny(patterns, path) || FitsAny(patterns, full);
      if (is_wanted && CanBeObserved(command.signature)) one.commands.push_back(command.name);
    }
  });
}

Result<void> CheckEventPatterns(const tendon::Catalogue& catalogue,
                                const std::vector<std::string>& patterns, CommandChoice choice) {
  for (const std::string& pattern : patterns) {
    const bool fits = !MatchingEvents(catalogue, {pattern}).empty() ||
                      !MatchingCommands(catalogue, {pattern}, choice).empty();
    if (!fits) return Misfit(catalogue, pattern);
  }
  return {};
}

}  // namespace console
