#include <gcm_gui/lifecycle/lifecycle_row.h>

#include <gcm_gui/call/hold_button.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>
#include <tendon/gcm/lifecycle/lifecycle_plan.h>

#include <QHBoxLayout>

namespace tendon::gui {

LifecycleRow::LifecycleRow(QWidget* parent) : QWidget(parent) {
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(kInset, kGrid, kInset, 2 * kGrid);
  line->setSpacing(kGrid);
  for (std::size_t i = 0; i < kLifecycleVerbs.size(); ++i) {
    const LifecycleVerb verb = kLifecycleVerbs[i];
    auto* button = new HoldButton(WordOf(verb));
    button->setObjectName(QStringLiteral("lifecycle.") + ToQString(ToString(verb)));
    button->setCareful(true);
    button->setProperty("changesSystem", true);
    connect(button, &HoldButton::called, this, [this, verb] { Q_EMIT chosen(verb); });
    connect(button, &HoldButton::releasedEarly, this,
            [this] { Q_EMIT notice(Words::tr("Nothing was done: hold the button for 0.4 s")); });
    // All buttons are equally wide, and together never wider than the panel.
    button->setMinimumWidth(1);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    line->addWidget(button);
    buttons_[i] = button;
  }
}

void LifecycleRow::show(const Catalogue& catalogue, const std::string& process,
                        const std::string& component) {
  for (std::size_t i = 0; i < kLifecycleVerbs.size(); ++i) {
    const auto checked = CheckLifecycleOrder(
        catalogue, {.verb = kLifecycleVerbs[i], .process = process, .component = component});
    const auto* known = catalogue.FindComponent(process, component);
    const QString effect =
        known == nullptr ? QString() : EffectOf(kLifecycleVerbs[i], known->state);
    buttons_[i]->setToolTip(checked ? (effect + ' ' + ButtonAdviceOf(kLifecycleVerbs[i])).trimmed()
                                    : ToQString(checked.error().message));
    buttons_[i]->setEnabled(checked.ok());
  }
}

}  // namespace tendon::gui
