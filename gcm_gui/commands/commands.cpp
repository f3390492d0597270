#include <gcm_gui/commands/commands.h>

#include <gcm_gui/language/words.h>

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <utility>

namespace tendon::gui {

Commands::Commands(QWidget& window)
    : QObject(&window), window_(window), bar_(new QMenuBar(&window)) {
  bar_->setObjectName(QStringLiteral("menus"));
  bar_->setNativeMenuBar(false);
  // With any other size policy, a narrow window would hide the last menus first.
  bar_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  menus_ = {bar_->addMenu(Words::tr("&System")), bar_->addMenu(Words::tr("&Plot")),
            bar_->addMenu(Words::tr("&Record")), bar_->addMenu(Words::tr("&Graph")),
            bar_->addMenu(Words::tr("&View")),   bar_->addMenu(Words::tr("&Help"))};
}

QAction& Commands::add(Menu menu, const QString& text, const QKeySequence& key,
                       std::function<void()> what) {
  QAction* action = this->menu(menu).addAction(text);
  action->setShortcut(key);
  action->setObjectName(PlainText(*action));
  connect(action, &QAction::triggered, this, std::move(what));
  window_.addAction(action);  // so that the key works while the menu is closed
  return *action;
}

QList<QAction*> Commands::actions() const {
  QList<QAction*> actions;
  for (const QMenu* menu : menus_) {
    for (QAction* action : menu->actions()) {
      if (!action->isSeparator() && action->menu() == nullptr) actions.append(action);
    }
  }
  return actions;
}

QString PlainText(const QAction& action) {
  QString text = action.text();
  return text.remove('&').remove(QStringLiteral("…"));
}

}  // namespace tendon::gui
