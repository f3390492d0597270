#pragma once

#include <gcm_gui/views/overlay_card.h>

class QBoxLayout;

namespace tendon::gui {

class Commands;

/// A card that lists keys. F1 lists all keys: the present keys of the menus, and the keys of
/// widgets that handle keys themselves. "?" lists only the keys of the focused widget.
class ShortcutsCard : public OverlayCard {
  Q_OBJECT

 public:
  /// Covers a part of `place`, which belongs to the window of `commands`.
  ShortcutsCard(QWidget& place, const Commands& commands);

  /// Opens or closes the card.
  void toggle();
  /// Opens or closes the card. If the focused widget handles keys itself, lists only those.
  void toggleOf(const QWidget* focused);

 private:
  void clear();
  void fill();

  const Commands& commands_;
  QBoxLayout* left_;
  QBoxLayout* right_;
};

}  // namespace tendon::gui
