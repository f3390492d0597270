#include <gcm_gui/lifecycle/lifecycle_card.h>

#include <gcm_gui/call/hold_button.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/header_row.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace tendon::gui {

LifecycleCard::LifecycleCard(QWidget& place)
    : OverlayCard(place, new QWidget),
      names_(MakeTextLine(QStringLiteral("lifecycle.names"), QStringLiteral("mono"))),
      advice_(MakeTextLine(QStringLiteral("lifecycle.advice"), QStringLiteral("dim"))),
      button_(new HoldButton({})) {
  setObjectName(QStringLiteral("lifecycleCard"));
  setAccessibleName(Words::tr("Start or stop"));
  button_->setObjectName(QStringLiteral("lifecycle.confirm"));
  button_->setCareful(true);
  button_->setProperty("changesSystem", true);
  SetRole(*button_, QStringLiteral("primary"));
  connect(button_, &HoldButton::called, this, &LifecycleCard::enter);
  connect(button_, &HoldButton::releasedEarly, this,
          [this] { Q_EMIT notice(Words::tr("Nothing was done: hold the button for 0.4 s")); });
  auto* lines = new QVBoxLayout(&body());
  lines->setContentsMargins(kInset, 2 * kGrid, kInset, 2 * kGrid);
  lines->setSpacing(2 * kGrid);
  lines->addWidget(names_);
  lines->addWidget(advice_);
  lines->addStretch();
  addToHead(button_);
}

void LifecycleCard::ask(LifecycleVerb verb, const std::vector<Path>& components,
                        const QStringList& lines, const QStringList& effects) {
  verb_ = verb;
  components_ = components;
  QStringList names;
  for (const Path& component : components) names.append(ToQString(ToString(component)));
  head().setTitle(TitleOf(verb, components.size()));
  setAccessibleName(WordOf(verb) + ' ' + names.join(' '));
  setAccessibleDescription(effects.join(' '));
  names_->setText(lines.join('\n'));
  advice_->setText((effects + QStringList{CardAdviceOf(verb)}).join('\n'));
  button_->setText(HoldWordOf(verb));
  open();
  setFocus(Qt::ShortcutFocusReason);
}

void LifecycleCard::enter() {
  close();
  Q_EMIT confirmed(verb_, components_);
}

/// If a key has opened the card and is still pressed, its repetitions are ignored.
void LifecycleCard::keyPressEvent(QKeyEvent* event) {
  if (event->isAutoRepeat()) return;
  const bool is_enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  // Enter must confirm here, because the button can only be held, not clicked.
  if (is_enter && window()->focusWidget() == button_) return enter();
  OverlayCard::keyPressEvent(event);
}

}  // namespace tendon::gui
