#include <tendon/gcm/connection_health.h>

#include <tendon/base/text.h>

namespace tendon {
namespace {

using FlawKind = ConnectionFlaw::Kind;

constexpr std::chrono::milliseconds kLongestRoundTrip{100};
constexpr double kFullest = 0.8;  // a mailbox with this part of its capacity in use is nearly full

/// True if a counter has grown; a smaller value means that it was reset.
bool HasGrown(std::uint64_t now, std::uint64_t before) {
  return now > before || (now < before && now > 0);
}

}  // namespace

std::vector<ConnectionFlaw> FlawsOf(const ConnectionCounts& now,
                                    const std::optional<ConnectionCounts>& before) {
  std::vector<ConnectionFlaw> flaws;
  if (before && HasGrown(now.refused, before->refused)) {
    flaws.push_back({.kind = FlawKind::kCallsRefused, .count = now.refused});
  }
  if (before && HasGrown(now.lost_events, before->lost_events)) {
    flaws.push_back({.kind = FlawKind::kEventsLost, .count = now.lost_events});
  }
  if (now.capacity > 0 &&
      static_cast<double>(now.waiting) >= kFullest * static_cast<double>(now.capacity)) {
    flaws.push_back(
        {.kind = FlawKind::kMailboxFull, .count = now.waiting, .capacity = now.capacity});
  }
  if (now.round_trip > kLongestRoundTrip) {
    flaws.push_back({.kind = FlawKind::kLate, .round_trip = now.round_trip});
  }
  return flaws;
}

std::string ToString(const ConnectionFlaw& flaw) {
  const std::string count = std::to_string(flaw.count);
  switch (flaw.kind) {
    case FlawKind::kCallsRefused:
      return Counted(flaw.count, "call was", "calls were") +
             " refused, because the mailbox was full";
    case FlawKind::kEventsLost:
      return Counted(flaw.count, "event was", "events were") + " lost";
    case FlawKind::kMailboxFull:
      return count + " of " + std::to_string(flaw.capacity) + " calls wait";
    case FlawKind::kLate:
      break;
  }
  return "answers after " + Milliseconds(flaw.round_trip);
}

}  // namespace tendon
