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

/// All commands of the window. Each command is in a menu and in the palette, and both show its key.
class Commands : public QObject {
  Q_OBJECT

 public:
  enum class Menu { kSystem, kPlot, kGraph, kView, kHelp };

  /// Keys work everywhere in `window`.
  explicit Commands(QWidget& window);

  /// `text` may mark a letter for the menu (&). The object name is the text without the mark.
  QAction& add(Menu menu, const QString& text, const QKeySequence& key, std::function<void()> what);
  [[nodiscard]] QMenu& menu(Menu menu) const { return *menus_[static_cast<std::size_t>(menu)]; }
  /// The caller places it.
  [[nodiscard]] QMenuBar& bar() const { return *bar_; }
  /// From left to right.
  [[nodiscard]] const std::array<QMenu*, 5>& menus() const { return menus_; }
  /// In the order of the menus.
  [[nodiscard]] QList<QAction*> actions() const;

 private:
  QWidget& window_;
  QMenuBar* bar_;
  std::array<QMenu*, 5> menus_{};
};

/// The text of an action without the menu's mark and dots.
[[nodiscard]] QString PlainText(const QAction& action);

}  // namespace tendon::gui
