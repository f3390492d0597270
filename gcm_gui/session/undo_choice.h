#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/messages.h>

#include <chrono>
#include <cstdint>
#include <string>

namespace tendon::gui {

/// Under which name this window asks for changes, and stands in the GCM's history: "gcm-gui of
/// anna@host".
[[nodiscard]] std::string NameOfThisWindow();

/// Which step an undo takes back: the newest that stands, whoever has made it. What another person
/// or program has done, or what was ordered of a component, is taken back at the second time only.
class UndoChoice {
 public:
  using Time = std::chrono::steady_clock::time_point;
  /// For so long the second time counts as the answer to the question of the first.
  static constexpr std::chrono::seconds kPatience{10};

  explicit UndoChoice(std::string me) : me_(std::move(me)) {}

  /// The id of the step. kNotFound where nothing stands; kFailed with a question for the user where
  /// he has to ask again. `wall_now` in ns since 1970.
  [[nodiscard]] Result<std::uint64_t> Choose(const message::History& history, Time now,
                                             std::int64_t wall_now);

 private:
  std::string me_;
  std::uint64_t asked_ = 0;  // the step of the newest question
  Time until_;
};

}  // namespace tendon::gui
