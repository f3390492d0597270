#include <gcm_gui/graph/graph_map.h>

#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/items/process_item.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

namespace tendon::gui {
namespace {

constexpr QSize kLargest{200, 140};
constexpr int kInside = 6;      // pixels from the border of the map to its graph
constexpr double kMinNode = 2;  // pixels; so each component is visible
constexpr int kMinView = 160;   // pixels; in a smaller view, the map would hide too much
constexpr double kSlack = 1;    // scene units that may be outside the view

}  // namespace

GraphMap::GraphMap(GraphView& graph) : QWidget(&graph), graph_(graph) {
  setObjectName(QStringLiteral("graphMap"));
  setAccessibleName(Words::tr("Map of the graph"));
  setAccessibleDescription(Words::tr(
      "The frame shows the visible part; to move it, press Shift and an arrow key in the graph"));
  setToolTip(Words::tr("Drag the frame to see another part  (M hides the map)"));
  setCursor(Qt::PointingHandCursor);
  hide();
  graph.installEventFilter(this);
  connect(&graph, &GraphView::moved, this, &GraphMap::follow);
  connect(&graph.graph(), &GraphScene::shown, this, &GraphMap::redraw);
  connect(&Theme::instance(), &Theme::changed, this, &GraphMap::redraw);
  follow();
}

void GraphMap::setWanted(bool wanted) {
  wanted_ = wanted;
  follow();
}

void GraphMap::redraw() {
  is_old_ = true;
  follow();
}

void GraphMap::follow() {
  const QRectF all = graph_.graph().contents();
  const QRectF inner = all.adjusted(kSlack, kSlack, -kSlack, -kSlack);
  const QRect room = graph_.rect();
  const bool has_room = std::min(room.width(), room.height()) >= kMinView;
  setVisible(wanted_ && has_room && !all.isEmpty() && !graph_.seen().contains(inner));
  if (isHidden()) return;
  const QSize most = kLargest.boundedTo({room.width() / 3, room.height() / 3});
  const QSizeF wanted =
      all.size().scaled(most - QSize(2 * kInside, 2 * kInside), Qt::KeepAspectRatio);
  const QSize size(std::max(static_cast<int>(wanted.width()), kRowHeight) + 2 * kInside,
                   std::max(static_cast<int>(wanted.height()), kRowHeight) + 2 * kInside);
  const int below = kRowHeight + 2 * kGrid;  // height of the zoom buttons, which are below the map
  setGeometry(QRect(
      room.bottomRight() - QPoint(size.width() + 2 * kGrid, size.height() + 2 * kGrid + below),
      size));
  update();
}

double GraphMap::scale() const {
  const QRectF all = graph_.graph().contents();
  if (all.isEmpty()) return 1;
  return std::min((width() - 2 * kInside) / all.width(), (height() - 2 * kInside) / all.height());
}

QPointF GraphMap::fromScene(const QPointF& point) const {
  const QRectF room(rect());
  return room.center() + (point - graph_.graph().contents().center()) * scale();
}

QRectF GraphMap::frame() const {
  const QRectF seen = graph_.seen();
  return QRectF(fromScene(seen.topLeft()), fromScene(seen.bottomRight()));
}

void GraphMap::drawContents() {
  const Theme& theme = Theme::instance();
  contents_ = QPixmap(size() * devicePixelRatioF());
  contents_.setDevicePixelRatio(devicePixelRatioF());
  contents_.fill(Qt::transparent);
  QPainter painter(&contents_);
  const auto small = [&](const QRectF& rect) {
    QRectF drawn(fromScene(rect.topLeft()), fromScene(rect.bottomRight()));
    drawn.setSize(drawn.size().expandedTo({kMinNode, kMinNode}));
    return drawn;
  };
  painter.setPen(theme.color(Token::kLine));
  painter.setBrush(theme.color(Token::kPanel));
  for (const auto& [name, item] : graph_.graph().processes()) {
    painter.drawRect(small(item->sceneBoundingRect()));
  }
  for (const auto& [path, item] : graph_.graph().components()) {
    painter.fillRect(small(item->sceneRect()), theme.color(item->token()));
  }
  is_old_ = false;
}

void GraphMap::paintEvent(QPaintEvent*) {
  const Theme& theme = Theme::instance();
  const bool fits = contents_.size() == size() * devicePixelRatioF() &&
                    contents_.devicePixelRatio() == devicePixelRatioF();
  if (is_old_ || !fits) drawContents();
  QPainter painter(this);
  const QRectF border = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.fillRect(rect(), theme.color(Token::kCanvas));
  painter.drawPixmap(0, 0, contents_);
  const QRectF seen = frame() & border;
  painter.setPen(QPen(theme.color(Token::kAccent), 1));
  painter.setBrush(theme.color(Token::kAccent, 0.12));
  painter.drawRect(seen);
  painter.setPen(theme.color(Token::kLine));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(border);
}

void GraphMap::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const QRectF seen = frame();
  // If the press is inside the frame, the frame moves with the pointer. If it is outside, the
  // centre of the frame moves to the pointer.
  held_ = seen.contains(event->position()) ? event->position() - seen.center() : QPointF();
  mouseMoveEvent(event);
}

void GraphMap::mouseMoveEvent(QMouseEvent* event) {
  if (!held_) return;
  const QPointF middle = event->position() - *held_ - QRectF(rect()).center();
  graph_.lookAt(graph_.graph().contents().center() + middle / scale());
}

void GraphMap::mouseReleaseEvent(QMouseEvent*) { held_.reset(); }

bool GraphMap::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) follow();
  return QWidget::eventFilter(watched, event);
}

}  // namespace tendon::gui
