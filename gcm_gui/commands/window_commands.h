#pragma once

#include <QObject>

namespace tendon::gui {

class CommandPalette;
class Commands;
class MainWindow;
class RedoStack;
class ShortcutsCard;
class LifecycleCommands;
class Tour;

/// Fills the menus and the palette of the window, and assigns its keys. Owns the objects that only
/// commands use.
class WindowCommands : public QObject {
  Q_OBJECT

 public:
  /// All views of `window` must exist.
  explicit WindowCommands(MainWindow& window);

  [[nodiscard]] Tour& tour() const { return *tour_; }
  /// Closes the list of keys, or else the card for starting and stopping; returns false if neither
  /// is open.
  bool closeCard();

 private:
  void addSystemCommands();
  void addLifecycleCommands();
  void addPlotCommands();
  void addHelpCommands();
  void addPalette();
  /// Disables what changes the system, and says why.
  void forbidChanges();

  MainWindow& window_;
  Commands* commands_;
  CommandPalette* palette_ = nullptr;
  RedoStack* redo_ = nullptr;
  LifecycleCommands* lifecycle_ = nullptr;
  ShortcutsCard* keys_ = nullptr;
  Tour* tour_ = nullptr;
};

}  // namespace tendon::gui
