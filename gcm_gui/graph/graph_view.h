#pragma once

#include <gcm_gui/connect/connect_mode.h>
#include <gcm_gui/graph/graph_scene.h>
#include <gcm_gui/graph/places/node_drag.h>
#include <gcm_gui/models/selection.h>

#include <QElapsedTimer>
#include <QGraphicsView>
#include <QPoint>
#include <chrono>
#include <optional>
#include <vector>

namespace tendon::gui {

/// The graph on the screen: wheel zooms, dragging moves the view, or what is dragged: a component,
/// or a process by its head. A click on a port begins or makes a connection (so does dragging from
/// port to port), a click on anything else selects it.
///
/// Until the user has zoomed or moved it, and again after fit(), all of the graph is shown in the
/// middle. What comes or goes moves nothing under a hand: a pointer that has just been moved there.
class GraphView : public QGraphicsView {
  Q_OBJECT

 public:
  GraphView(GraphScene& scene, Selection& selection, ConnectMode& mode, QWidget* parent = nullptr);

  [[nodiscard]] GraphScene& graph() const { return scene_; }
  /// The middle of a port's disc on this widget's viewport; nothing when there is no such port.
  [[nodiscard]] std::optional<QPoint> pointOf(const PortName& port) const;
  /// For how long a pointer that was moved counts as a hand; 3 s at the start.
  void setHandRests(std::chrono::milliseconds rests) { hand_rests_ = rests; }
  /// What is seen of the graph, in its own coordinates.
  [[nodiscard]] QRectF seen() const;
  /// The required interfaces of the connections that work and can be seen.
  [[nodiscard]] std::vector<InterfaceName> seenConnections() const;
  /// Of the interface, component or connection that is there; empty where none is.
  [[nodiscard]] QString pathAt(const QPoint& position) const;
  /// What is being dragged to another place goes back; false where nothing is.
  bool putBack();

 public Q_SLOTS:
  void fit();
  /// Brings this point to the middle, as it is.
  void lookAt(const QPointF& point);
  void zoomIn() { zoom(1.25); }
  void zoomOut() { zoom(0.8); }
  /// Selects the component of this path and shows it in the middle, large enough to be read.
  void goTo(const QString& path);
  /// Moves the view, if it must, so that the component of `path` can be seen.
  void reveal(const QString& path);

 Q_SIGNALS:
  /// An edge that does not work was clicked.
  void whyRequested(const QString& required);
  /// Whether the graph is on the screen.
  void seenChanged(bool seen);
  /// Another part of it is seen, or at another scale.
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
  [[nodiscard]] bool handIsOnIt() const;
  void showAll();
  void tellSeen();
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
  /// Of the component, or of the process whose head is there: what a drag takes along.
  [[nodiscard]] QString nodeAt(const QPoint& position) const;

  GraphScene& scene_;
  Selection& selection_;
  ConnectMode& mode_;
  bool following_ = true;
  std::optional<QPoint> pressed_;
  std::optional<PortName> pressed_port_;
  QString pressed_node_;  // that is dragged, once it is moved
  std::optional<NodeDrag> node_drag_;
  bool dragging_ = false;
  std::optional<QPoint> pointer_;
  std::chrono::milliseconds hand_rests_{3000};
  QElapsedTimer pointer_moved_;  // since it was moved here
};

}  // namespace tendon::gui
