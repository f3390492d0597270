#pragma once

#include <tendon/gcm/catalogue.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tendon {

/// The reason why the values of a component are not current.
enum class StaleReason {
  kNone,
  kNotStarted,
  kSuspended,
  kFinished,
  kFaulted,
  kUnresponsive,
  kLost
};

/// "suspended", "not started", "no reply"; "running" for kNone.
[[nodiscard]] constexpr std::string_view ToString(StaleReason why) noexcept {
  switch (why) {
    case StaleReason::kNone:
      return "running";
    case StaleReason::kNotStarted:
      return "not started";
    case StaleReason::kSuspended:
      return "suspended";
    case StaleReason::kFinished:
      return "finished";
    case StaleReason::kFaulted:
      return "faulted";
    case StaleReason::kUnresponsive:
      return "no reply";
    case StaleReason::kLost:
      break;
  }
  return "lost";
}

/// Returns the reason why the values of a component are not current; kNone if they are. The state
/// of the component counts only while its process is alive.
[[nodiscard]] constexpr StaleReason StaleReasonOf(ProcessState process,
                                                  ComponentState component) noexcept {
  if (process == ProcessState::kSuspect) return StaleReason::kUnresponsive;
  if (process != ProcessState::kAlive) return StaleReason::kLost;
  switch (component) {
    case ComponentState::kConstructed:
    case ComponentState::kReady:
      return StaleReason::kNotStarted;
    case ComponentState::kActive:
      return StaleReason::kNone;
    case ComponentState::kSuspended:
      return StaleReason::kSuspended;
    case ComponentState::kFinished:
      return StaleReason::kFinished;
    case ComponentState::kFaulted:
      break;
  }
  return StaleReason::kFaulted;
}

/// Determines the reason from the catalogue. A component that is not in the catalogue counts as
/// lost.
[[nodiscard]] inline StaleReason StaleReasonOf(const Catalogue& catalogue,
                                               const std::string& process,
                                               const std::string& component) {
  const ProcessEntry* entry = catalogue.FindProcess(process);
  if (entry == nullptr) return StaleReason::kLost;
  const auto found = entry->components.find(component);
  if (found == entry->components.end()) return StaleReason::kLost;
  return StaleReasonOf(entry->process.state, found->second.state);
}

/// Returns true if the console and the window must mark a value as stale. `age` is the age of its
/// row, if known. `rate` is the rate of rows in Hz, 0 if unknown.
///
/// If the component runs, a value is stale when the next row is overdue. If the component does not
/// run, a value is stale unless its row is younger than 500 ms. A younger row may have arrived just
/// before the component stopped.
[[nodiscard]] inline bool IsStale(StaleReason why, std::optional<std::chrono::nanoseconds> age,
                                  double rate) {
  constexpr std::chrono::milliseconds kOnItsWay{500};
  constexpr std::chrono::duration<double> kLate{2};
  constexpr double kMaxPeriods = 5;
  if (why != StaleReason::kNone) return !age || *age > kOnItsWay;
  if (!age || rate <= 0) return false;
  return *age > std::max(kLate, std::chrono::duration<double>(kMaxPeriods / rate));
}

/// Returns an age as text: "12 s", "3 min", "2 h", "5 d".
[[nodiscard]] inline std::string AgeText(std::chrono::nanoseconds age) {
  constexpr std::int64_t kMinute = 60;
  constexpr std::int64_t kHour = 60 * kMinute;
  constexpr std::int64_t kDay = 24 * kHour;
  const std::int64_t seconds =
      std::max<std::int64_t>(0, std::chrono::duration_cast<std::chrono::seconds>(age).count());
  if (seconds < 2 * kMinute) return std::to_string(seconds) + " s";
  if (seconds < 2 * kHour) return std::to_string(seconds / kMinute) + " min";
  if (seconds < 2 * kDay) return std::to_string(seconds / kHour) + " h";
  return std::to_string(seconds / kDay) + " d";
}

}  // namespace tendon
