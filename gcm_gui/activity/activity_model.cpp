#include <gcm_gui/activity/activity_model.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/models/text.h>

#include <algorithm>
#include <utility>

namespace tendon::gui {
namespace {

constexpr std::size_t kKept = 500;

QString VerbText(const Action& action) {
  switch (action.verb) {
    case Action::Verb::kConnect:
      return QStringLiteral("connect");
    case Action::Verb::kDisconnect:
      return QStringLiteral("disconnect");
    case Action::Verb::kReplace:
      return QStringLiteral("replace");
    case Action::Verb::kUndo:
      return QStringLiteral("undo");
    case Action::Verb::kForget:
      return QStringLiteral("forget");
    case Action::Verb::kLifecycle:
      return ToQString(ToString(action.lifecycle_verb));
    case Action::Verb::kCall:
      return QStringLiteral("call");
    case Action::Verb::kLogLevel:
      return Words::tr("log level");
    case Action::Verb::kApply:
      return QStringLiteral("apply");
    case Action::Verb::kRecord:
      return QStringLiteral("record");
    case Action::Verb::kSaveLast:
      return QStringLiteral("save-last");
  }
  return {};
}

bool IsStep(const Action& action) {
  const bool wiring = action.verb == Action::Verb::kConnect ||
                      action.verb == Action::Verb::kDisconnect ||
                      action.verb == Action::Verb::kReplace;
  // A restart can be undone only if the component was not running. Only the GCM knows whether it
  // was, so a restart does not count as a step here.
  const bool lifecycle =
      action.verb == Action::Verb::kLifecycle && action.lifecycle_verb != LifecycleVerb::kRestart;
  return (wiring || lifecycle) && action.outcome == Action::Outcome::kDone && !action.undone;
}

bool DidTheSame(const Action& action, const Action& step) {
  return action.verb == step.verb && action.required == step.required &&
         action.component == step.component && action.lifecycle_verb == step.lifecycle_verb;
}

StateMark OutcomeMark(const Action& action) {
  switch (action.outcome) {
    case Action::Outcome::kRunning:
      return StateMark::kPending;
    case Action::Outcome::kDone:
      return action.undone ? StateMark::kFinished : StateMark::kActive;
    case Action::Outcome::kRefused:
      break;
  }
  return StateMark::kWarning;
}

}  // namespace

int ActivityModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(entries_.size());
}

int ActivityModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumnCount;
}

const Action& ActivityModel::action(int row) const {
  return entries_.at(entries_.size() - 1 - static_cast<std::size_t>(row)).action;
}

QString ActivityModel::object(const Action& action) const {
  if (action.verb == Action::Verb::kApply || action.verb == Action::Verb::kRecord ||
      action.verb == Action::Verb::kSaveLast) {
    return action.argument;
  }
  if (!action.process.empty()) {
    return QString(ToQString(action.process) + ' ' + action.argument).trimmed();
  }
  if (!action.component.empty()) return ToQString(action.component);
  if (!action.command.isEmpty()) return (action.command + ' ' + action.argument).trimmed();
  if (action.required.interface.empty()) return {};
  if (action.provided.interface.empty()) return ToQString(action.required);
  return ToQString(action.required) + QStringLiteral(" → ") + ToQString(action.provided);
}

QString ActivityModel::outcome(const Action& action) const {
  switch (action.outcome) {
    case Action::Outcome::kRunning:
      return QStringLiteral("…");
    case Action::Outcome::kRefused:
      return action.refusal;
    case Action::Outcome::kDone:
      break;
  }
  QString time = DurationText(action.seconds);
  if (action.times > 1) time += Words::tr(" · %1 times").arg(action.times);
  return action.undone ? time + Words::tr(" · undone") : time;
}

QVariant ActivityModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.column() != kWhat) return {};
  const Action& action = this->action(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return VerbText(action);
    case kTimeRole:
      return ClockText(action.when);
    case kGlyphMarkRole:
      return QVariant::fromValue(OutcomeMark(action));
    case kObjectRole:
      return object(action);
    case kDetailRole:
    case Qt::ToolTipRole:
      return outcome(action);
    case kPathRole:
      if (!action.component.empty()) return ToQString(action.component);
      if (!action.command.isEmpty()) return action.command;
      return action.required.interface.empty() ? ToQString(action.process)
                                               : ToQString(action.required);
    case Qt::AccessibleTextRole:
      return QStringList{VerbText(action), object(action), outcome(action)}.join(' ');
    default:
      return {};
  }
}

QString ActivityModel::command(int row) const {
  const Action& action = this->action(row);
  switch (action.verb) {
    case Action::Verb::kConnect:
      return QStringLiteral("gcm connect %1 %2")
          .arg(ToQString(action.required), ToQString(action.provided));
    case Action::Verb::kDisconnect:
      return QStringLiteral("gcm disconnect %1").arg(ToQString(action.required));
    case Action::Verb::kReplace:
      return QStringLiteral("gcm connect %1 %2 --replace")
          .arg(ToQString(action.required), ToQString(action.provided));
    case Action::Verb::kUndo:
      return QStringLiteral("gcm undo");
    case Action::Verb::kLifecycle:
      return QStringLiteral("gcm %1 %2").arg(VerbText(action), ToQString(action.component));
    case Action::Verb::kCall:
      return CallLine(action.command, action.argument);
    case Action::Verb::kLogLevel:
      return QStringLiteral("gcm log-level %1 %2").arg(ToQString(action.process), action.argument);
    case Action::Verb::kApply:
      return action.file.isEmpty() ? QString()
                                   : QStringLiteral("gcm apply ") + ShellWord(action.file);
    case Action::Verb::kRecord:
    case Action::Verb::kSaveLast:
      return QStringLiteral("gcm %1 %2 -o %3")
          .arg(VerbText(action), action.argument, ShellWord(action.file));
    case Action::Verb::kForget:
      break;
  }
  return {};
}

bool ActivityModel::canUndo(int row) const { return lastStep() == &action(row); }

const Action* ActivityModel::lastStep() const {
  for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
    const bool is_plan = entry->action.verb == Action::Verb::kApply;
    if (is_plan && entry->action.outcome != Action::Outcome::kRunning) return nullptr;
    if (IsStep(entry->action)) return &entry->action;
  }
  return nullptr;
}

bool ActivityModel::isOnceMore(const Action& action) const {
  if (action.verb != Action::Verb::kCall || entries_.empty()) return false;
  const Action& last = entries_.back().action;
  return last.verb == action.verb && last.command == action.command &&
         last.argument == action.argument && last.outcome == Action::Outcome::kDone;
}

ActivityModel::Id ActivityModel::begin(Action action) {
  if (isOnceMore(action)) {
    Action& last = entries_.back().action;
    ++last.times;
    last.when = WallClock();
    last.outcome = Action::Outcome::kRunning;
    changed(0);
    return entries_.back().id;
  }
  if (entries_.size() == kKept) {
    const auto last = static_cast<int>(kKept) - 1;
    beginRemoveRows({}, last, last);
    entries_.erase(entries_.begin());
    endRemoveRows();
  }
  action.when = WallClock();
  beginInsertRows({}, 0, 0);
  entries_.push_back({++last_id_, std::move(action)});
  endInsertRows();
  return last_id_;
}

int ActivityModel::rowOf(Id id) const {
  const auto it = std::find_if(entries_.rbegin(), entries_.rend(),
                               [&](const Entry& entry) { return entry.id == id; });
  return it == entries_.rend() ? -1 : static_cast<int>(it - entries_.rbegin());
}

void ActivityModel::changed(int row) {
  Q_EMIT dataChanged(index(row, 0), index(row, kColumnCount - 1));
}

void ActivityModel::finish(Id id, double seconds, const QString& refusal) {
  const int row = rowOf(id);
  if (row < 0) return;
  Action& action = entries_[entries_.size() - 1 - static_cast<std::size_t>(row)].action;
  action.seconds = seconds;
  action.refusal = refusal;
  action.outcome = refusal.isEmpty() ? Action::Outcome::kDone : Action::Outcome::kRefused;
  changed(row);
  changedUndo();
  Q_EMIT finished(Action(action));
}

void ActivityModel::changedUndo() {
  // Both the newest step that is not undone and the step before this one may have changed.
  int steps = 0;
  for (int row = 0; row < rowCount() && steps < 2; ++row) {
    if (!IsStep(action(row))) continue;
    changed(row);
    ++steps;
  }
}

void ActivityModel::markUndone(Id undo, const Action& step) {
  for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
    Action& action = entry->action;
    if (entry->id == undo) {
      action.required = step.required;
      action.provided = step.provided;
      action.component = step.component;
      changed(static_cast<int>(entry - entries_.rbegin()));
    } else if (IsStep(action) && DidTheSame(action, step)) {
      action.undone = true;
      changed(static_cast<int>(entry - entries_.rbegin()));
      changedUndo();
      return Q_EMIT undone(Action(action));
    }
  }
}

}  // namespace tendon::gui
