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

/// Which panels there are around the middle of a window, and how large: four perspectives on keys,
/// panels that can be moved once that is asked for, and a layout that can be kept.
class Panels : public QObject {
  Q_OBJECT

 public:
  enum class Perspective { kConnect, kPlot, kOperate, kDiagnose };

  /// `centre` has two rows, the graph above the plots.
  Panels(QMainWindow& window, QSplitter& centre);

  /// Takes what the window shows at that edge; `size` is across the edge, in pixels.
  void add(QWidget* content, const QString& title, Qt::DockWidgetArea area, int size, int least);
  /// Adds perspectives, panels, and what else can be done with them. After the last add().
  void fill(QMenu& menu);

  void show(Perspective perspective);
  void setMovable(bool movable);
  /// Shows the panel that has this in it.
  void reveal(const QWidget& content);
  /// Makes the panel that has this in it at least so large across its edge, in pixels.
  void giveRoom(const QWidget& content, int size);
  /// All as it was at the first start.
  void reset();

  [[nodiscard]] QByteArray state() const;
  /// What is no state, or one of other panels, changes nothing.
  void restore(const QByteArray& state);

 Q_SIGNALS:
  void shown(tendon::gui::Panels::Perspective perspective);
  /// All else that can be arranged is to be as at the first start, too.
  void wasReset();

 private:
  struct Panel {
    QDockWidget* dock;
    Qt::DockWidgetArea area;  // where it stands at first
  };
  [[nodiscard]] static Qt::Orientation across(Qt::DockWidgetArea area);

  QMainWindow& window_;
  QSplitter& centre_;
  std::vector<Panel> panels_;
  QAction* movable_ = nullptr;
};

}  // namespace tendon::gui
