#pragma once

#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>
#include <array>
#include <cstddef>
#include <functional>

class QAction;
class QMenu;
class QMenuBar;
class QWidget;

namespace tendon::gui {

/// All commands of the window. Each command is in a menu and in the palette; both show its key.
class Commands : public QObject {
  Q_OBJECT

 public:
  enum class Menu { kSystem, kPlot, kRecord, kGraph, kView, kHelp };

  /// Creates the empty menus. The keys of the commands work everywhere in `window`.
  explicit Commands(QWidget& window);

  /// Adds a command that calls `what`. `text` may mark a letter for the menu with `&`. The object
  /// name of the action is the text without the mark.
  QAction& add(Menu menu, const QString& text, const QKeySequence& key, std::function<void()> what);
  [[nodiscard]] QMenu& menu(Menu menu) const { return *menus_[static_cast<std::size_t>(menu)]; }
  /// The menu bar; the caller adds it to a layout.
  [[nodiscard]] QMenuBar& bar() const { return *bar_; }
  /// All menus, from left to right.
  [[nodiscard]] const std::array<QMenu*, 6>& menus() const { return menus_; }
  /// All commands, in the order of the menus.
  [[nodiscard]] QList<QAction*> actions() const;

 private:
  QWidget& window_;
  QMenuBar* bar_;
  std::array<QMenu*, 6> menus_{};
};

/// Returns the text of an action without the `&` of the menu and without an ellipsis.
[[nodiscard]] QString PlainText(const QAction& action);

}  // namespace tendon::gui
