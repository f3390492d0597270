#include <gcm_gui/models/state_marks.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/connection_index.h>
#include <gcm_gui/models/text.h>
#include <tendon/gcm/waiting.h>

#include <QStringList>

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

std::vector<UnsatisfiedInterface> WaitsOf(const ConnectionIndex& connections,
                                          const ProcessEntry& process,
                                          const ComponentDescription& component) {
  return tendon::WaitsOf(process, component, [&](const std::string& interface) {
    return connections.Of({process.process.name, component.name, interface});
  });
}

StateMark MarkOf(ComponentState state, const std::vector<UnsatisfiedInterface>& waits) {
  return waits.empty() ? MarkOf(state) : StateMark::kWarning;
}

QString WordOf(ComponentState state, const std::vector<UnsatisfiedInterface>& waits) {
  return waits.empty() ? WordOf(MarkOf(state))
                       : Words::tr("waiting for ") + ToQString(NamesOf(waits));
}

QString ReasonsText(const std::vector<UnsatisfiedInterface>& waits) {
  QStringList reasons;
  for (const UnsatisfiedInterface& need : waits) {
    const QString reason =
        need.has_connection ? ToQString(need.reason) : WordOf(StateMark::kNotConnected);
    reasons << ToQString(need.interface) + QStringLiteral(": ") + reason;
  }
  return reasons.join(QStringLiteral("; "));
}

QString WordOf(ProcessState state) {
  switch (state) {
    case ProcessState::kAlive:
      return Words::tr("alive");
    case ProcessState::kSuspect:
      return Words::tr("no reply");
    case ProcessState::kLost:
      return WordOf(StateMark::kLost);
    case ProcessState::kStarting:
      return Words::tr("starting");
    case ProcessState::kLeft:
      break;
  }
  return Words::tr("left", "of a process");
}

QString WordOf(StaleReason why) {
  switch (why) {
    case StaleReason::kNone:
      break;
    case StaleReason::kNotStarted:
      return Words::tr("not started");
    case StaleReason::kSuspended:
      return WordOf(StateMark::kSuspended);
    case StaleReason::kFinished:
      return WordOf(StateMark::kFinished);
    case StaleReason::kFaulted:
      return WordOf(StateMark::kFaulted);
    case StaleReason::kUnresponsive:
      return WordOf(ProcessState::kSuspect);
    case StaleReason::kLost:
      return WordOf(StateMark::kLost);
  }
  return {};
}

QString OldText(StaleReason why, std::optional<std::chrono::nanoseconds> age) {
  const QString word = WordOf(why);
  if (!age) return word;
  const QString old = Words::tr("%1 old").arg(AgeText(age->count()));
  return word.isEmpty() ? old : word + QStringLiteral(" · ") + old;
}

bool IsGone(ProcessState state) {
  return state != ProcessState::kAlive && state != ProcessState::kSuspect;
}

}  // namespace tendon::gui
