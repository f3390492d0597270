#pragma once

#include <gcm_gui/connect/connect_mode.h>
#include <gcm_gui/graph/graph_scene.h>
#include <gcm_gui/models/selection.h>

#include <QElapsedTimer>
#include <QGraphicsView>
#include <QPoint>
#include <chrono>
#include <optional>

namespace tendon::gui {

/// The graph on the screen: wheel zooms, dragging moves, a click on a port begins or makes a
/// connection (so does dragging from port to port), a click on anything else selects it.
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

 public Q_SLOTS:
  void fit();
  void zoomIn() { zoom(1.25); }
  void zoomOut() { zoom(0.8); }
  /// Moves the view, if it must, so that the component of `path` can be seen.
  void reveal(const QString& path);

 Q_SIGNALS:
  /// An edge that does not work was clicked.
  void whyRequested(const QString& required);
  /// Whether the graph is on the screen.
  void seenChanged(bool seen);

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
  [[nodiscard]] QRectF seen() const;
  void pan(const QPoint& position);
  void dragConnection(const QPoint& position);
  void click(const QPoint& position);
  bool connectKey(int key);
  void selectNext(int key);
  [[nodiscard]] std::optional<PortName> portAt(const QPoint& position) const;

  GraphScene& scene_;
  Selection& selection_;
  ConnectMode& mode_;
  bool following_ = true;
  std::optional<QPoint> pressed_;
  std::optional<PortName> pressed_port_;
  bool dragging_ = false;
  std::optional<QPoint> pointer_;
  std::chrono::milliseconds hand_rests_{3000};
  QElapsedTimer pointer_moved_;  // since it was moved here
};

}  // namespace tendon::gui
