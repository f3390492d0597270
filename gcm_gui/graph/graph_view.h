#pragma once

#include <gcm_gui/connect/connect_mode.h>
#include <gcm_gui/graph/graph_scene.h>
#include <gcm_gui/graph/node_drag.h>
#include <gcm_gui/models/selection.h>

#include <QElapsedTimer>
#include <QGraphicsView>
#include <QPoint>
#include <chrono>
#include <optional>
#include <vector>

namespace tendon::gui {

/// Shows the graph on the screen. The wheel zooms. The user can drag a component or the title bar
/// of a process to move it; any other drag moves the view. A click on a port begins or completes a
/// connection; a drag from one port to another makes a connection. A click on any other item
/// selects it.
///
/// Fits the whole graph into the view until the user zooms or moves the view, and again after
/// fit(). While the user moves the pointer, the view is not refitted if the whole graph is visible.
class GraphView : public QGraphicsView {
  Q_OBJECT

 public:
  static constexpr std::chrono::milliseconds kPointerTimeout{3000};

  /// The pointer still counts as moving for `pointer_timeout` after its last move.
  GraphView(GraphScene& scene, Selection& selection, ConnectMode& mode,
            std::chrono::milliseconds pointer_timeout = kPointerTimeout, QWidget* parent = nullptr);

  [[nodiscard]] GraphScene& graph() const { return scene_; }
  /// Returns the centre of a port's disc in viewport coordinates; empty if the port does not exist.
  [[nodiscard]] std::optional<QPoint> pointOf(const PortName& port) const;
  /// The visible part, in scene coordinates.
  [[nodiscard]] QRectF seen() const;
  /// The required interfaces of the working connections that are visible.
  [[nodiscard]] std::vector<InterfaceName> visibleConnections() const;
  /// The path of the interface, component or connection at this position; empty if there is none.
  [[nodiscard]] QString pathAt(const QPoint& position) const;
  /// Cancels a drag of a component or process; returns false if there is none.
  bool cancelDrag();

 public Q_SLOTS:
  void fit();
  /// Centres the view on this point without changing the scale.
  void lookAt(const QPointF& point);
  void zoomIn() { zoom(1.25); }
  void zoomOut() { zoom(0.8); }
  /// Selects the component of this path, centres it, and zooms in until it can be read.
  void goTo(const QString& path);
  /// Moves the view, if necessary, so that the component of `path` is visible.
  void reveal(const QString& path);

 Q_SIGNALS:
  /// Emitted when the user has clicked the edge of a connection that does not work.
  void whyRequested(const QString& required);
  /// Emitted when the graph becomes visible or hidden.
  void visibilityChanged(bool visible);
  /// Emitted when the visible part or the scale has changed.
  void moved();

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void scrollContentsBy(int dx, int dy) override;

 private:
  void zoom(double factor);
  void follow();
  [[nodiscard]] bool isPointerMoving() const;
  void showAll();
  void updateVisibleArea();
  void scrollBy(const QPoint& pixels);
  void pan(const QPoint& position);
  void dragConnection(const QPoint& position);
  void click(const QPoint& position);
  bool connectKey(int key);
  bool panKey(const QKeyEvent& event);
  bool moveKey(const QKeyEvent& event);
  void beginDrag();
  void selectNext(int key);
  [[nodiscard]] std::optional<PortName> portAt(const QPoint& position) const;
  /// Returns the item that a drag at this position moves: a component, or a process if the position
  /// is on its title bar. Empty if there is none.
  [[nodiscard]] QString nodeAt(const QPoint& position) const;

  GraphScene& scene_;
  Selection& selection_;
  ConnectMode& mode_;
  const std::chrono::milliseconds pointer_timeout_;
  bool following_ = true;
  std::optional<QPoint> pressed_;
  std::optional<PortName> pressed_port_;
  QString pressed_node_;  // dragged when the pointer moves
  std::optional<NodeDrag> node_drag_;
  bool dragging_ = false;
  std::optional<QPoint> pointer_;
  QElapsedTimer pointer_moved_;  // time since the last move of the pointer in this view
};

}  // namespace tendon::gui
