#include <tendon/gcm/history.h>
#include <tendon/gcm/text/step_text.h>
#include <tendon/gcm/text/wall_time.h>

namespace tendon {

std::string WholeText(const message::HistoryEntry& step) {
  return "step " + std::to_string(step.id) + " (" + ToString(step) + ", by " + step.who + " at " +
         WallTimeText(step.when) + ")";
}

}  // namespace tendon
