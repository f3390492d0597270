#include <gcm_gui/models/text.h>
#include <gcm_gui/session/undo_choice.h>
#include <tendon/base/os/process.h>
#include <tendon/gcm/history.h>
#include <tendon/gcm/text/step_text.h>

#include <QString>
#include <algorithm>
#include <utility>

namespace tendon::gui {
namespace {

std::string Question(const message::HistoryEntry& step, std::int64_t wall_now) {
  const std::string motion =
      IsOfLife(step) ? "; taking it back can set something in motion" : std::string();
  return "the newest step is '" + ToString(step) + "', by " + step.who + " " +
         AgeText(wall_now - step.when).toStdString() + " ago" + motion +
         ". Undo it? Ctrl+Z once more within " + std::to_string(UndoChoice::kPatience.count()) +
         " s does";
}

}  // namespace

std::string NameOfThisWindow() {
  const QString user = qEnvironmentVariable("USER", qEnvironmentVariable("LOGNAME"));
  return "gcm-gui of " + (user.isEmpty() ? std::string() : user.toStdString() + '@') +
         os::HostName();
}

Result<std::uint64_t> UndoChoice::Choose(const message::History& history, Time now,
                                         std::int64_t wall_now) {
  const auto& all = history.entries;
  const auto newest = std::find_if(
      all.rbegin(), all.rend(), [](const auto& step) { return !step.undone && !step.passed_over; });
  if (newest == all.rend()) return Error{ErrorCode::kNotFound, "there is nothing to undo"};
  const bool is_answered = std::exchange(asked_, 0) == newest->id && now <= until_;
  if (is_answered || (newest->who == me_ && !IsOfLife(*newest))) return newest->id;
  asked_ = newest->id;
  until_ = now + kPatience;
  return Error{ErrorCode::kFailed, Question(*newest, wall_now)};
}

}  // namespace tendon::gui
