#pragma once

#include <gcm_gui/views/overlay_card.h>

class QBoxLayout;

namespace tendon::gui {

class Commands;

/// All keys on one card (F1): those of the menus, as they are now, and those that mean something
/// where the focus is; or these alone (?).
class KeysCard : public OverlayCard {
  Q_OBJECT

 public:
  /// Over `place`, a part of the window that `commands` are of.
  KeysCard(QWidget& place, const Commands& commands);

  /// Opens it; closes it where it is open.
  void toggle();
  /// The same with the keys of the part alone that has the focus, where it has some of its own.
  void toggleOf(const QWidget* focused);

 private:
  void clear();
  void fill();

  const Commands& commands_;
  QBoxLayout* left_;
  QBoxLayout* right_;
};

}  // namespace tendon::gui
