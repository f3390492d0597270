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

/// The commands that start, suspend, stop and restart the selected components. They are in the menu
/// "System", in the palette and in the context menu of a component, and have keys.
class LifecycleCommands : public QObject {
  Q_OBJECT

 public:
  /// Confirmations appear over `place`, a part of the window.
  LifecycleCommands(const CatalogueStore& store, Selection& selection, SystemActions& actions,
                    QWidget& place);

  void addCommands(Commands& commands);
  /// Fills the context menu of components with the commands of this class and with the commands
  /// named in `others`.
  void fillMenu(const Commands& commands, const QStringList& others);
  /// The context menu for the selection.
  [[nodiscard]] QMenu& menu() const { return *menu_; }
  [[nodiscard]] LifecycleCard& card() const { return *card_; }
  /// Asks for confirmation. If the verb is impossible, shows the reason instead.
  void ask(LifecycleVerb verb);

 Q_SIGNALS:
  /// Emitted with one sentence for the user.
  void notice(const QString& text);

 private:
  /// Returns the selected components without duplicates, in the order of selection.
  [[nodiscard]] std::vector<Path> selectedComponents() const;
  /// Returns why all selected components would refuse the verb; empty if at least one would accept
  /// it.
  [[nodiscard]] QString refusalOf(LifecycleVerb verb) const;
  /// Disables the verbs that would be refused; called while the context menu of a component is
  /// open.
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
