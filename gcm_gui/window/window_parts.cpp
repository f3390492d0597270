#include <gcm_gui/session/gcm_session.h>
#include <gcm_gui/window/window_parts.h>

namespace tendon::gui {

WindowParts PartsOf(GcmSession& session) {
  return {.store = session.store(),
          .link = session.link(),
          .activity = session.activity(),
          .actions = session,
          .source = session.liveSignals(),
          .calls = session,
          .checks = session,
          .plans = session.plans(),
          .reports = session.reports(),
          .recordings = session.recordings()};
}

}  // namespace tendon::gui
