#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/gcm_messages.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

namespace tendon::gui {

/// Returns the name of this window in its requests and in the history of the GCM: "gcm-gui of
/// anna@host".
[[nodiscard]] std::string NameOfThisWindow();

/// Chooses the step to undo: the newest step that is not undone, by any user or program. A step of
/// another user or program, or a step on the lifecycle of a component, must be requested twice.
class UndoChoice {
 public:
  using Time = std::chrono::steady_clock::time_point;
  /// A second request within this time confirms the first.
  static constexpr std::chrono::seconds kTimeout{10};

  explicit UndoChoice(std::string me) : me_(std::move(me)) {}

  /// Returns the id of the step. Errors: kNotFound if there is none; kFailed, with a question for
  /// the user, if a second request is needed. `wall_now` is in ns since 1970.
  [[nodiscard]] Result<std::uint64_t> Choose(const message::History& history, Time now,
                                             std::int64_t wall_now);

 private:
  std::string me_;
  std::uint64_t asked_ = 0;  // the step that needs a second request
  Time until_;
};

}  // namespace tendon::gui
