#pragma once

#include <QPixmap>
#include <QPointF>
#include <QRectF>
#include <QWidget>
#include <optional>

namespace tendon::gui {

class GraphView;

/// A small map of the whole graph in the lower right corner, with a frame around the visible part.
/// A click or a drag moves the view. The map is hidden while the whole graph is visible.
class GraphMap : public QWidget {
  Q_OBJECT

 public:
  explicit GraphMap(GraphView& graph);

  /// True if the user allows the map, which is the default. It then appears when the graph is
  /// larger than its view.
  [[nodiscard]] bool isWanted() const { return wanted_; }
  /// The frame around the visible part, in coordinates of this widget.
  [[nodiscard]] QRectF frame() const;
  /// Maps a point of the graph to this widget.
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
  QPixmap contents_;  // drawn again only when outdated
  bool is_old_ = true;
  std::optional<QPointF> held_;  // during a drag: from the centre of the frame to the grab point
};

}  // namespace tendon::gui
