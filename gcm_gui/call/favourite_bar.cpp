#include <gcm_gui/call/favourite_bar.h>

#include <gcm_gui/call/hold_button.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/models/text.h>
#include <tendon/base/path.h>

#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <algorithm>

namespace tendon::gui {
namespace {

constexpr qsizetype kLongestArgument = 24;

/// Returns "arm · MoveTo", followed by the argument if it is short.
QString FavouriteTitle(const Favourite& favourite) {
  const QString member = favourite.path.section('.', -1);
  QString title = favourite.path.section('/', 1, 1) + QStringLiteral(" · ") + member;
  const bool is_short = favourite.argument.size() <= kLongestArgument;
  if (!favourite.argument.isEmpty() && is_short) title += ' ' + favourite.argument;
  return title;
}

}  // namespace

FavouriteBar::FavouriteBar(Favourites& favourites, const CatalogueStore& store, CommandCalls& calls,
                           QWidget* parent)
    : QToolBar(Words::tr("Favourites"), parent),
      favourites_(favourites),
      store_(store),
      calls_(calls) {
  setObjectName(QStringLiteral("favourites"));
  setAccessibleName(Words::tr("Favourite commands"));
  setAutoFillBackground(true);
  connect(&favourites, &Favourites::changed, this, &FavouriteBar::build);
  connect(&store, &CatalogueStore::changed, this, Guarded(this, &FavouriteBar::refresh));
  build();
}

void FavouriteBar::build() {
  clear();
  buttons_.clear();
  for (const Favourite& favourite : favourites_.all()) {
    auto* button = new HoldButton(FavouriteTitle(favourite));
    button->setObjectName(QStringLiteral("favourite.") + favourite.path);
    button->setAccessibleName(Words::tr("Call ") + favourite.path);
    button->setProperty("changesSystem", true);
    button->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(button, &HoldButton::called, this, [this, favourite] { call(favourite); });
    connect(button, &HoldButton::releasedEarly, this, [this] {
      Q_EMIT notice(
          Words::tr("Not called: this command can move something; hold the button "
                    "for 0.4 s"));
    });
    connect(button, &QWidget::customContextMenuRequested, this,
            [this, favourite, button](const QPoint& place) {
              openMenu(favourite, button->mapToGlobal(place));
            });
    addWidget(button);
    buttons_.append({favourite, button});
  }
  setVisible(!buttons_.isEmpty());
  refresh();
}

void FavouriteBar::refresh() {
  for (const Button& one : buttons_) show(one);
}

void FavouriteBar::show(const Button& one) {
  const auto path = ParsePath(one.favourite.path.toStdString());
  const Catalogue& catalogue = store_.catalogue();
  const ProcessEntry* entry = path.ok() ? catalogue.FindProcess(path->process) : nullptr;
  const auto* provided = path.ok() ? catalogue.FindProvided(path->interface_name()) : nullptr;
  const MemberDescription* command = nullptr;
  if (provided != nullptr) {
    const auto found = std::find_if(provided->commands.begin(), provided->commands.end(),
                                    [&](const auto& known) { return known.name == path->member; });
    if (found != provided->commands.end()) command = &*found;
  }
  const bool is_there = command != nullptr && !IsGone(entry->process.state);
  one.button->setEnabled(is_there);
  if (!is_there) {
    return one.button->setToolTip(Words::tr("Waiting for ") + one.favourite.path);
  }
  const auto* component = catalogue.FindComponent(path->process, path->component);
  const bool is_careful = component != nullptr && NeedsCare(*command, component->state);
  one.button->setCareful(is_careful);
  one.button->setToolTip(
      CallLine(one.favourite.path, one.favourite.argument) +
      (is_careful ? Words::tr("\nThis command can move something: hold the button for 0.4 s")
                  : QString()));
}

void FavouriteBar::call(const Favourite& favourite) {
  // Does nothing with the result, because the activity list shows it.
  calls_.callCommand(favourite.path.toStdString(), favourite.argument.toStdString(),
                     [](const auto& /*result*/, double /*seconds*/) {});
}

void FavouriteBar::openMenu(const Favourite& favourite, const QPoint& place) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(Words::tr("Show the command"), this,
                  [this, favourite] { Q_EMIT pathChosen(favourite.path); });
  menu->addAction(Words::tr("Copy as command"), this, [favourite] {
    QApplication::clipboard()->setText(CallLine(favourite.path, favourite.argument));
  });
  menu->addAction(Words::tr("Remove from favourites"), this,
                  [this, favourite] { favourites_.remove(favourite); });
  menu->popup(place);
}

}  // namespace tendon::gui
