#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/gcm_messages.h>

#include <chrono>
#include <cstdint>
#include <string>

namespace tendon::gui {

/// The name of this window in its requests and in the GCM's history: "gcm-gui of anna@host".
[[nodiscard]] std::string NameOfThisWindow();

/// Chooses the step to undo: the newest that is not undone, by any author. A step of another person
/// or program, or on a component's lifecycle, needs a second request.
class UndoChoice {
 public:
  using Time = std::chrono::steady_clock::time_point;
  /// How long a second request confirms the first.
  static constexpr std::chrono::seconds kPatience{10};

  explicit UndoChoice(std::string me) : me_(std::move(me)) {}

  /// Returns the id of the step. kNotFound if there is none; kFailed with a question for the user
  /// if a second request is needed. `wall_now` in ns since 1970.
  [[nodiscard]] Result<std::uint64_t> Choose(const message::History& history, Time now,
                                             std::int64_t wall_now);

 private:
  std::string me_;
  std::uint64_t asked_ = 0;  // the step for which confirmation was requested last
  Time until_;
};

}  // namespace tendon::gui
