#pragma once

#include <gcm_gui/call/favourites.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/system_requests.h>

#include <QList>
#include <QToolBar>

namespace tendon::gui {

class HoldButton;

/// A tool bar with one button for each favourite command. A button is grey while the command's
/// component does not exist. It must be held down if the command can move something. The bar is
/// hidden while there are no favourites.
class FavouriteBar : public QToolBar {
  Q_OBJECT

 public:
  FavouriteBar(Favourites& favourites, const CatalogueStore& store, CommandCalls& calls,
               QWidget* parent = nullptr);

 Q_SIGNALS:
  /// Emitted with one sentence that says why a button did nothing.
  void notice(const QString& text);
  void pathChosen(const QString& path);

 private:
  struct Button {
    Favourite favourite;
    HoldButton* button;
  };

  void build();
  void refresh();
  void show(const Button& one);
  void call(const Favourite& favourite);
  void openMenu(const Favourite& favourite, const QPoint& place);

  Favourites& favourites_;
  const CatalogueStore& store_;
  CommandCalls& calls_;
  QList<Button> buttons_;
};

}  // namespace tendon::gui
