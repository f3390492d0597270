#include <gcm_gui/language/words.h>
#include <gcm_gui/models/state_of.h>

namespace tendon::gui {

StateMark MarkOf(ProcessState state) {
  switch (state) {
    case ProcessState::kAlive:
      return StateMark::kActive;
    case ProcessState::kSuspect:
      return StateMark::kWarning;
    case ProcessState::kLost:
      return StateMark::kLost;
    case ProcessState::kStarting:
      return StateMark::kPending;
    case ProcessState::kLeft:
      break;
  }
  return StateMark::kFinished;
}

StateMark MarkOf(ComponentState state) {
  switch (state) {
    case ComponentState::kConstructed:
      return StateMark::kConstructed;
    case ComponentState::kReady:
      return StateMark::kReady;
    case ComponentState::kActive:
      return StateMark::kActive;
    case ComponentState::kSuspended:
      return StateMark::kSuspended;
    case ComponentState::kFinished:
      return StateMark::kFinished;
    case ComponentState::kFaulted:
      break;
  }
  return StateMark::kFaulted;
}

StateMark MarkOf(ConnectionState state) {
  switch (state) {
    case ConnectionState::kPending:
      return StateMark::kPending;
    case ConnectionState::kActive:
      return StateMark::kConnected;
    case ConnectionState::kFailed:
      break;
  }
  return StateMark::kRefused;
}

StateMark MarkOf(const ConnectionDescription* connection) {
  return connection == nullptr ? StateMark::kNotConnected : MarkOf(connection->state);
}

QString WordOf(ProcessState state) {
  switch (state) {
    case ProcessState::kAlive:
      return Words::tr("alive");
    case ProcessState::kSuspect:
      return Words::tr("no answer");
    case ProcessState::kLost:
      return WordOf(StateMark::kLost);
    case ProcessState::kStarting:
      return Words::tr("starting");
    case ProcessState::kLeft:
      break;
  }
  return Words::tr("left", "of a process");
}

bool IsGone(ProcessState state) {
  return state != ProcessState::kAlive && state != ProcessState::kSuspect;
}

}  // namespace tendon::gui
