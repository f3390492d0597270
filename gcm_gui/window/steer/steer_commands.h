#pragma once

#include <gcm_gui/models/selection.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/system_actions.h>
#include <gcm_gui/steer/steer_words.h>
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
class SteerCard;

/// Starts, suspends, stops and restarts the components that are selected: in the menu "System", on
/// keys, in the palette, and in the menu of a component itself.
class SteerCommands : public QObject {
  Q_OBJECT

 public:
  /// Asks over `place`, a part of the window.
  SteerCommands(const CatalogueStore& store, Selection& selection, SystemActions& actions,
                QWidget& place);

  void addCommands(Commands& commands);
  /// The commands of this class, and those of these names.
  void fillMenu(const Commands& commands, const QStringList& others);
  /// For whatever is selected.
  [[nodiscard]] QMenu& menu() const { return *menu_; }
  [[nodiscard]] SteerCard& card() const { return *card_; }
  /// Asks once more, or says why it is not to be had.
  void ask(LifeVerb verb);

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  /// Each once, in the order of selecting.
  [[nodiscard]] std::vector<Path> selectedComponents() const;
  /// Why none of what is selected would do it; empty where one would.
  [[nodiscard]] QString refusalOf(LifeVerb verb) const;
  /// While the menu of a component is open.
  void disableRefused();
  void enableRefused();
  [[nodiscard]] QString lineOf(LifeVerb verb, const Path& one) const;
  void carryOut(LifeVerb verb, const std::vector<Path>& components);

  const CatalogueStore& store_;
  Selection& selection_;
  SystemActions& actions_;
  SteerCard* card_;
  QMenu* menu_;
  QList<QAction*> own_;
  QList<QAction*> refused_;  // while the menu is open
};

}  // namespace tendon::gui
