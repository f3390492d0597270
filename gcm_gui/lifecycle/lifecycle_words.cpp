#include <gcm_gui/lifecycle/lifecycle_words.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/models/text.h>

namespace tendon::gui {
namespace {

bool EndsSomething(LifecycleVerb verb) {
  return verb == LifecycleVerb::kSuspend || verb == LifecycleVerb::kStop;
}

}  // namespace

QString WordOf(LifecycleVerb verb) {
  switch (verb) {
    case LifecycleVerb::kStart:
      return Words::tr("Start");
    case LifecycleVerb::kSuspend:
      return Words::tr("Suspend");
    case LifecycleVerb::kStop:
      return Words::tr("Stop");
    case LifecycleVerb::kRestart:
      return Words::tr("Restart");
    default:
      return ToQString(ToString(verb));
  }
}

QString HoldWordOf(LifecycleVerb verb) {
  switch (verb) {
    case LifecycleVerb::kStart:
      return Words::tr("Hold to start");
    case LifecycleVerb::kSuspend:
      return Words::tr("Hold to suspend");
    case LifecycleVerb::kStop:
      return Words::tr("Hold to stop");
    case LifecycleVerb::kRestart:
      return Words::tr("Hold to restart");
    default:
      return WordOf(verb);
  }
}

QString TitleOf(LifecycleVerb verb, std::size_t components) {
  const bool is_one = components == 1;
  const auto title = [&](const QString& one, const QString& several) {
    return is_one ? one : several.arg(components);
  };
  switch (verb) {
    case LifecycleVerb::kStart:
      return title(Words::tr("Start the component"), Words::tr("Start %1 components"));
    case LifecycleVerb::kSuspend:
      return title(Words::tr("Suspend the component"), Words::tr("Suspend %1 components"));
    case LifecycleVerb::kStop:
      return title(Words::tr("Stop the component"), Words::tr("Stop %1 components"));
    case LifecycleVerb::kRestart:
      return title(Words::tr("Restart the component"), Words::tr("Restart %1 components"));
    default:
      return WordOf(verb);
  }
}

QString EffectOf(LifecycleVerb verb, ComponentState state) {
  const bool is_suspended = state == ComponentState::kSuspended;
  if (verb == LifecycleVerb::kStart && is_suspended) {
    return Words::tr(
        "The component is notified that it was suspended. If its author has written code for this "
        "case, the component starts from the current situation; otherwise the component continues "
        "its previous action.");
  }
  if (verb == LifecycleVerb::kStart || verb == LifecycleVerb::kRestart) {
    return Words::tr("The component starts from the beginning: no previous action continues.");
  }
  return {};
}

QString StateWithDuration(const QString& path, ComponentState state,
                          std::optional<std::int64_t> since, std::int64_t now) {
  const QString word = WordOf(MarkOf(state));
  return path + QStringLiteral(" · ") +
         (since ? Words::tr("%1 for %2", "a state, a time").arg(word, AgeText(now - *since))
                : word);
}

QString ButtonAdviceOf(LifecycleVerb verb) {
  return EndsSomething(verb)
             ? Words::tr("This order stops what the component does: hold the button for 0.4 s")
             : Words::tr("This order can move something: hold the button for 0.4 s");
}

QString CardAdviceOf(LifecycleVerb verb) {
  return EndsSomething(verb)
             ? Words::tr(
                   "This order stops what the component does: hold the button for 0.4 s, or "
                   "press Enter")
             : Words::tr(
                   "This order can move something: hold the button for 0.4 s, or press Enter");
}

}  // namespace tendon::gui
