#pragma once

#include <gcm_gui/lifecycle/lifecycle_words.h>
#include <gcm_gui/models/selection.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/system_requests.h>
#include <tendon/base/path.h>

#include <QList>
#include <QObject>
#include <QString>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace tendon::gui {

class Commands;
class LifecycleCard;

/// Starts, suspends, stops and restarts the selected components: in the menu "System", on keys, in
/// the palette, and in a component's own menu.
class LifecycleCommands : public QObject {
  Q_OBJECT

 public:
  /// Confirmations appear over `place`, a part of the window.
  LifecycleCommands(const CatalogueStore& store, Selection& selection, SystemActions& actions,
                    QWidget& place);

  void addCommands(Commands& commands);
  /// Fills the component menu with the commands of this class and the other named ones.
  void fillMenu(const Commands& commands, const QStringList& others);
  /// The menu for the selection.
  [[nodiscard]] QMenu& menu() const { return *menu_; }
  [[nodiscard]] LifecycleCard& card() const { return *card_; }
  /// Asks for confirmation, or shows the reason why the verb is impossible.
  void ask(LifecycleVerb verb);

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  /// Without duplicates, in the order of selection.
  [[nodiscard]] std::vector<Path> selectedComponents() const;
  /// The reason why all selected components would refuse the verb; empty if one would accept it.
  [[nodiscard]] QString refusalOf(LifecycleVerb verb) const;
  /// Disables refused verbs while a component's menu is open.
  void disableRefused();
  void enableRefused();
  [[nodiscard]] QString lineOf(LifecycleVerb verb, const Path& one) const;
  void carryOut(LifecycleVerb verb, const std::vector<Path>& components);

  const CatalogueStore& store_;
  Selection& selection_;
  SystemActions& actions_;
  LifecycleCard* card_;
  QMenu* menu_;
  QList<QAction*> own_;
  QList<QAction*> refused_;  // disabled while the menu is open
};

}  // namespace tendon::gui
