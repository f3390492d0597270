#pragma once

#include <gcm_gui/call/favourites/favourites.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/command_calls.h>

#include <QList>
#include <QToolBar>

namespace tendon::gui {

class HoldButton;

/// An operator's panel: a button for each favourite command. One whose component is gone waits for
/// it, grey; one that can set something in motion has to be held. Not there without favourites.
class FavouriteBar : public QToolBar {
  Q_OBJECT

 public:
  FavouriteBar(Favourites& favourites, const CatalogueStore& store, CommandCalls& calls,
               QWidget* parent = nullptr);

 Q_SIGNALS:
  /// One sentence about what a button did not do.
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
