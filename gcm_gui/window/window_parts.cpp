#include <gcm_gui/window/window_parts.h>

#include <gcm_gui/replay/replay_session.h>
#include <gcm_gui/session/gcm_session.h>

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

WindowParts PartsOf(ReplaySession& session) {
  return {.store = session.store(),
          .link = session.link(),
          .activity = session.activity(),
          .actions = session.refusals(),
          .source = session.signalSource(),
          .calls = session.refusals(),
          .checks = session.refusals(),
          .plans = session.refusals(),
          .reports = session.reports(),
          .recordings = session.recordings(),
          .replay = &session,
          .read_only = session.reason()};
}

}  // namespace tendon::gui
