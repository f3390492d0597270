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

/// The panels around the middle of a window and their sizes: four perspectives with keys, panels
/// that can be moved after a command has unlocked them, and a layout that can be saved.
class Panels : public QObject {
  Q_OBJECT

 public:
  enum class Perspective { kConnect, kPlot, kOperate, kDiagnose };

  /// `centre` has two rows, with the graph above the plots.
  Panels(QMainWindow& window, QSplitter& centre);

  /// Adds a panel at this edge; `size` is across the edge, in pixels.
  void add(QWidget* content, const QString& title, Qt::DockWidgetArea area, int size, int least);
  /// Adds perspectives, panels and layout commands to the menu. Call it after the last add().
  void fill(QMenu& menu);

  void show(Perspective perspective);
  void setMovable(bool movable);
  /// Shows the panel that contains this widget.
  void reveal(const QWidget& content);
  /// Makes the panel of this widget at least this wide across its edge, in pixels.
  void ensureSize(const QWidget& content, int size);
  /// Restores the default layout.
  void reset();

  [[nodiscard]] QByteArray state() const;
  /// Ignores an invalid state, or one of other panels.
  void restore(const QByteArray& state);

 Q_SIGNALS:
  void shown(tendon::gui::Panels::Perspective perspective);
  /// Emitted after reset(): everything else that can be arranged must return to its default as
  /// well.
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
