#include <tendon/gcm/history.h>
#include <tendon/gcm/text/step_text.h>
#include <tendon/gcm/text/wall_time.h>

namespace tendon {

std::string WholeText(const message::HistoryEntry& step) {
  return "step " + std::to_string(step.id) + " (" + ToString(step) + ", by " + step.who + " at " +
         WallTimeText(step.when) + ")";
}

bool IsOfLife(const message::HistoryEntry& step) { return !step.life.process.empty(); }

bool IsOfProcess(const message::HistoryEntry& step) {
  return IsOfLife(step) && step.life.component.empty();
}

const std::string& ProcessOf(const message::HistoryEntry& step) {
  return IsOfLife(step) ? step.life.process : step.wire.required.process;
}

}  // namespace tendon
