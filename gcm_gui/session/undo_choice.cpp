#include <gcm_gui/session/undo_choice.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <tendon/base/os/process.h>
#include <tendon/gcm/step_history.h>
#include <tendon/gcm/text.h>

#include <QString>
#include <algorithm>
#include <utility>

namespace tendon::gui {
namespace {

/// Returns true if `who` is `program`. If there is a certificate, the GCM writes its name first:
/// "anna (gcm-gui of ...)".
bool IsBy(const std::string& who, const std::string& program) {
  return who == program || who.ends_with(" (" + program + ")");
}

std::string Question(const message::HistoryEntry& step, std::int64_t wall_now) {
  const QString question =
      Words::tr("To undo '%2' (by %3, %4 ago), press Ctrl+Z again within %1 s")
          .arg(UndoChoice::kTimeout.count())
          .arg(ToQString(ToString(step)), ToQString(step.who), AgeText(wall_now - step.when));
  const QString motion =
      IsLifecycleStep(step) ? Words::tr("; this undo can move something") : QString();
  return (question + motion).toStdString();
}

}  // namespace

std::string NameOfThisWindow() { return "gcm-gui of " + os::UserAtHost(); }

Result<std::uint64_t> UndoChoice::Choose(const message::History& history, Time now,
                                         std::int64_t wall_now) {
  const auto& all = history.entries;
  const auto newest = std::find_if(
      all.rbegin(), all.rend(), [](const auto& step) { return !step.undone && !step.passed_over; });
  if (newest == all.rend()) {
    return Error{ErrorCode::kNotFound, Words::tr("there is nothing to undo").toStdString()};
  }
  const bool is_answered = std::exchange(asked_, 0) == newest->id && now <= until_;
  if (is_answered || (IsBy(newest->who, me_) && !IsLifecycleStep(*newest))) return newest->id;
  asked_ = newest->id;
  until_ = now + kTimeout;
  return Error{ErrorCode::kFailed, Question(*newest, wall_now)};
}

}  // namespace tendon::gui
