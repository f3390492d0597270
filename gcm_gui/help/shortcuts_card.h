#pragma once

#include <gcm_gui/views/overlay_card.h>

class QBoxLayout;

namespace tendon::gui {

class Commands;

/// Shows all keys on a card (F1): the present keys of the menus, and those of the widgets with
/// their own keys; or only those of the focused widget (?).
class ShortcutsCard : public OverlayCard {
  Q_OBJECT

 public:
  /// Covers a part of `place`, which belongs to the window of `commands`.
  ShortcutsCard(QWidget& place, const Commands& commands);

  /// Opens or closes the card.
  void toggle();
  /// The same, with only the keys of the focused part if it has its own keys.
  void toggleOf(const QWidget* focused);

 private:
  void clear();
  void fill();

  const Commands& commands_;
  QBoxLayout* left_;
  QBoxLayout* right_;
};

}  // namespace tendon::gui
