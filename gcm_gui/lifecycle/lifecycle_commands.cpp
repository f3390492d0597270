#include <gcm_gui/lifecycle/lifecycle_commands.h>

#include <gcm_gui/commands/commands.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/lifecycle/lifecycle_card.h>
#include <gcm_gui/models/text.h>
#include <tendon/gcm/lifecycle/lifecycle_plan.h>

#include <QAction>
#include <QMenu>
#include <algorithm>

namespace tendon::gui {
namespace {

QKeySequence ShortcutOf(LifecycleVerb verb) {
  switch (verb) {
    case LifecycleVerb::kStart:
      return Qt::Key_F6;
    case LifecycleVerb::kSuspend:
      return Qt::Key_F7;
    case LifecycleVerb::kStop:
      return Qt::Key_F8;
    case LifecycleVerb::kRestart:
      return Qt::Key_F9;
    default:
      return {};
  }
}

}  // namespace

LifecycleCommands::LifecycleCommands(const CatalogueStore& store, Selection& selection,
                                     SystemActions& actions, QWidget& place)
    : QObject(&place),
      store_(store),
      selection_(selection),
      actions_(actions),
      card_(new LifecycleCard(place)),
      menu_(new QMenu(&place)) {
  menu_->setObjectName(QStringLiteral("componentMenu"));
  menu_->setToolTipsVisible(true);
  connect(card_, &LifecycleCard::confirmed, this, &LifecycleCommands::carryOut);
  connect(card_, &OverlayCard::notice, this, &LifecycleCommands::notice);
  connect(menu_, &QMenu::aboutToShow, this, &LifecycleCommands::disableRefused);
  connect(menu_, &QMenu::aboutToHide, this, &LifecycleCommands::enableRefused);
}

void LifecycleCommands::addCommands(Commands& commands) {
  for (const LifecycleVerb verb : kLifecycleVerbs) {
    own_.append(&commands.add(Commands::Menu::kSystem, WordOf(verb) + QStringLiteral("…"),
                              ShortcutOf(verb), [this, verb] { ask(verb); }));
  }
}

void LifecycleCommands::fillMenu(const Commands& commands, const QStringList& others) {
  menu_->addActions(own_);
  menu_->addSeparator();
  for (QAction* action : commands.actions()) {
    if (others.contains(action->objectName())) menu_->addAction(action);
  }
}

std::vector<Path> LifecycleCommands::selectedComponents() const {
  std::vector<Path> components;
  for (const QString& path : selection_.paths()) {
    const auto parsed = ParsePath(path.toStdString());
    if (!parsed || parsed->component.empty()) continue;
    const Path component{.process = parsed->process, .component = parsed->component};
    if (std::find(components.begin(), components.end(), component) == components.end()) {
      components.push_back(component);
    }
  }
  return components;
}

QString LifecycleCommands::refusalOf(LifecycleVerb verb) const {
  QString first;
  for (const Path& one : selectedComponents()) {
    const auto checked = CheckLifecycleOrder(
        store_.catalogue(), {.verb = verb, .process = one.process, .component = one.component});
    if (checked) return {};
    if (first.isEmpty()) first = ToQString(checked.error().message);
  }
  return first;
}

void LifecycleCommands::disableRefused() {
  for (std::size_t i = 0; i < kLifecycleVerbs.size(); ++i) {
    QAction* action = own_[static_cast<qsizetype>(i)];
    const QString refusal = refusalOf(kLifecycleVerbs[i]);
    if (refusal.isEmpty() || !action->isEnabled()) continue;
    action->setEnabled(false);
    action->setToolTip(refusal);
    refused_.append(action);
  }
}

/// Enables the verbs again when the menu is closed, so that their keys show why they are refused.
void LifecycleCommands::enableRefused() {
  for (QAction* action : refused_) {
    action->setEnabled(true);
    action->setToolTip({});
  }
  refused_.clear();
}

void LifecycleCommands::ask(LifecycleVerb verb) {
  const std::vector<Path> selected = selectedComponents();
  if (selected.empty()) {
    return Q_EMIT notice(Words::tr("Select a component to start, suspend, stop or restart it"));
  }
  std::vector<Path> able;
  QString refusal;
  for (const Path& one : selected) {
    const auto checked = CheckLifecycleOrder(
        store_.catalogue(), {.verb = verb, .process = one.process, .component = one.component});
    if (checked) able.push_back(one);
    if (!checked && refusal.isEmpty()) refusal = ToQString(checked.error().message);
  }
  if (!refusal.isEmpty()) Q_EMIT notice(refusal);
  if (able.empty()) return card_->close();
  QStringList lines;
  QStringList effects;
  for (const Path& one : able) {
    lines.append(lineOf(verb, one));
    const auto* component = store_.catalogue().FindComponent(one.process, one.component);
    const QString effect = component == nullptr ? QString() : EffectOf(verb, component->state);
    if (!effect.isEmpty() && !effects.contains(effect)) effects.append(effect);
  }
  card_->ask(verb, able, lines, effects);
}

/// Returns the line for a component. If the verb would resume it, the line also says how long it
/// was suspended.
QString LifecycleCommands::lineOf(LifecycleVerb verb, const Path& one) const {
  const QString path = ToQString(ToString(one));
  const auto* component = store_.catalogue().FindComponent(one.process, one.component);
  const bool goes_on = verb == LifecycleVerb::kStart && component != nullptr &&
                       component->state == ComponentState::kSuspended;
  if (!goes_on) return path;
  return StateWithDuration(path, component->state, store_.stateSince(one.process, one.component),
                           WallClock());
}

void LifecycleCommands::carryOut(LifecycleVerb verb, const std::vector<Path>& components) {
  for (const Path& one : components)
    actions_.executeLifecycleOrder(verb, one.process, one.component);
}

}  // namespace tendon::gui
