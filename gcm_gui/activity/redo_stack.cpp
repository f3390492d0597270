#include <gcm_gui/activity/redo_stack.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>

#include <utility>

namespace tendon::gui {
namespace {

bool ChangesConnections(const Action& action) {
  return action.verb == Action::Verb::kConnect || action.verb == Action::Verb::kDisconnect ||
         action.verb == Action::Verb::kReplace;
}

}  // namespace

RedoStack::RedoStack(ActivityModel& activity, SystemActions& actions, QObject* parent)
    : QObject(parent), actions_(actions) {
  connect(&activity, &ActivityModel::undone, this,
          [this](const Action& action) { undone_.push_back(action); });
  connect(&activity, &ActivityModel::finished, this, Guarded(this, &RedoStack::onDone));
}

void RedoStack::onDone(const Action& action) {
  if (!ChangesConnections(action) && action.verb != Action::Verb::kLifecycle) return;
  if (!std::exchange(is_under_way_, false)) undone_.clear();
}

void RedoStack::again() {
  if (is_under_way_) return;
  if (undone_.empty()) return Q_EMIT notice(Words::tr("There is nothing to redo"));
  if (!ChangesConnections(undone_.back())) {
    return Q_EMIT notice(
        Words::tr("Starting and stopping cannot be redone: start or stop the component again, for "
                  "example with F6 to F9"));
  }
  const Action action = std::move(undone_.back());
  undone_.pop_back();
  is_under_way_ = true;
  if (action.verb == Action::Verb::kConnect) {
    actions_.connectInterfaces(action.required, action.provided);
  } else if (action.verb == Action::Verb::kReplace) {
    actions_.connectOrReplace(action.required, action.provided);
  } else {
    actions_.disconnectInterface(action.required);
  }
}

}  // namespace tendon::gui
