#include <gcm_console/catalogue/event_choice.h>
#include <gcm_console/catalogue/path_target.h>
#include <tendon/base/path.h>

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

}  // namespace

std::vector<tendon::EventSubscription> MatchingEvents(const tendon::Catalogue& catalogue,
                                                      const std::vector<std::string>& patterns) {
  std::vector<tendon::EventSubscription> all;
  for (const auto& [process, entry] : catalogue.processes()) {
    for (const auto& [component, description] : entry.components) {
      for (const auto& provided : description.provided) {
        tendon::EventSubscription one{.provided = {process, component, provided.name},
                                      .events = {}};
        const std::string path = ToString(one.provided);
        for (const auto& event : provided.events) {
          if (FitsAny(patterns, path) || FitsAny(patterns, path + "." + event.name)) {
            one.events.push_back(event.name);
          }
        }
        if (!one.events.empty()) all.push_back(std::move(one));
      }
    }
  }
  return all;
}

Result<void> CheckEventPatterns(const tendon::Catalogue& catalogue,
                                const std::vector<std::string>& patterns) {
  for (const std::string& pattern : patterns) {
    if (MatchingEvents(catalogue, {pattern}).empty()) return Misfit(catalogue, pattern);
  }
  return {};
}

}  // namespace console
