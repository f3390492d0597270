#pragma once

#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>
#include <array>
#include <functional>

class QAction;
class QMenu;
class QMenuBar;
class QWidget;

namespace tendon::gui {

/// All that can be done with the window, in menus, by key, and from the palette: whoever finds one
/// of the three finds the other two.
class Commands : public QObject {
  Q_OBJECT

 public:
  enum class Menu { kSystem, kPlot, kGraph, kView, kHelp };

  /// Keys work anywhere in `window`.
  explicit Commands(QWidget& window);

  /// `text` may have a letter for the menu (&). Its object name is the text without it.
  QAction& add(Menu menu, const QString& text, const QKeySequence& key, std::function<void()> what);
  [[nodiscard]] QMenu& menu(Menu menu) const { return *menus_[static_cast<std::size_t>(menu)]; }
  /// To be placed by the caller.
  [[nodiscard]] QMenuBar& bar() const { return *bar_; }
  /// From the left.
  [[nodiscard]] const std::array<QMenu*, 5>& menus() const { return menus_; }
  /// In the order of the menus.
  [[nodiscard]] QList<QAction*> actions() const;

 private:
  QWidget& window_;
  QMenuBar* bar_;
  std::array<QMenu*, 5> menus_{};
};

/// The text of an action as it is read: without the menu's letter and dots.
[[nodiscard]] QString PlainText(const QAction& action);

}  // namespace tendon::gui
