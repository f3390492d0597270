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

/// Fills the menus and the palette of the window, and assigns the keys. Owns the objects that are
/// used only by commands.
class WindowCommands : public QObject {
  Q_OBJECT

 public:
  /// All views of `window` must exist.
  explicit WindowCommands(MainWindow& window);

  [[nodiscard]] Tour& tour() const { return *tour_; }
  /// Closes the list of keys or, if that is not open, the card for starting and stopping. Returns
  /// false if neither is open.
  bool closeCard();

 private:
  void addSystemCommands();
  void addRecordingCommands();
  void addLifecycleCommands();
  void addPlotCommands();
  void addHelpCommands();
  void addPalette();
  /// Disables all commands that change the system; their tool tips say why.
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
