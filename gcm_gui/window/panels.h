#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>
#include <vector>

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;
class QSplitter;
class QWidget;

namespace tendon::gui {

/// The panels around the middle of a window, and their sizes. There are four perspectives with
/// keys; a command unlocks the panels so that the user can move them; and the layout can be saved.
class Panels : public QObject {
  Q_OBJECT

 public:
  enum class Perspective { kConnect, kPlot, kOperate, kDiagnose };

  /// `centre` has two rows: the graph above the plots.
  Panels(QMainWindow& window, QSplitter& centre);

  /// Adds a panel at an edge of the window. `size` and `least` are its width (left or right edge)
  /// or height (lower edge) in pixels.
  void add(QWidget* content, const QString& title, Qt::DockWidgetArea area, int size, int least);
  /// Adds the perspectives, the panels and the layout commands to the menu. Call it after the last
  /// add().
  void fill(QMenu& menu);

  void show(Perspective perspective);
  void setMovable(bool movable);
  /// Shows the panel that contains this widget.
  void reveal(const QWidget& content);
  /// Makes the panel of this widget at least `size` pixels wide or, at the lower edge, high.
  void ensureSize(const QWidget& content, int size);
  /// Restores the default layout.
  void reset();

  [[nodiscard]] QByteArray state() const;
  /// Restores a saved layout. Ignored if the state is invalid, or comes from a window with other
  /// panels.
  void restore(const QByteArray& state);

 Q_SIGNALS:
  void shown(tendon::gui::Panels::Perspective perspective);
  /// Emitted after reset(). Everything else that the user can arrange must then return to its
  /// default, too.
  void wasReset();

 private:
  struct Panel {
    QDockWidget* dock;
    Qt::DockWidgetArea area;  // its default edge
  };
  [[nodiscard]] static Qt::Orientation across(Qt::DockWidgetArea area);

  QMainWindow& window_;
  QSplitter& centre_;
  std::vector<Panel> panels_;
  QAction* movable_ = nullptr;
};

}  // namespace tendon::gui
