#pragma once

#include <QPixmap>
#include <QPointF>
#include <QRectF>
#include <QWidget>
#include <optional>

namespace tendon::gui {

class GraphView;

/// All of the graph, small, in its lower right corner, with a frame around what is seen: a click
/// or a drag shows another part. Only there while the graph is larger than its view.
class GraphMap : public QWidget {
  Q_OBJECT

 public:
  explicit GraphMap(GraphView& graph);

  /// Whether it comes when there is more than can be seen; it does at first.
  [[nodiscard]] bool isWanted() const { return wanted_; }
  /// Of what is seen, on this widget.
  [[nodiscard]] QRectF frame() const;
  /// Where a point of the graph is, on this widget.
  [[nodiscard]] QPointF fromScene(const QPointF& point) const;

 public Q_SLOTS:
  void setWanted(bool wanted);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void follow();
  void redraw();
  void drawContents();
  [[nodiscard]] double scale() const;

  GraphView& graph_;
  bool wanted_ = true;
  QPixmap contents_;  // drawn anew when it is needed
  bool is_old_ = true;
  std::optional<QPointF> held_;  // from the middle of the frame, while the mouse has it
};

}  // namespace tendon::gui
