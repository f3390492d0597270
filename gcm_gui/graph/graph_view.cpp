#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/items/port_item.h>
#include <gcm_gui/graph/items/process_item.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/tendon_style.h>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QScrollBar>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr double kLeastScale = 0.08;
constexpr double kMostScale = 2.5;
constexpr double kMostFitted = 1.2;  // a small graph in a large window
constexpr double kMargin = 12;

bool IsPan(const QPoint& moved) {
  return moved.manhattanLength() >= QApplication::startDragDistance();
}

}  // namespace

GraphView::GraphView(GraphScene& scene, Selection& selection, ConnectMode& mode, QWidget* parent)
    : QGraphicsView(&scene, parent), scene_(scene), selection_(selection), mode_(mode) {
  setObjectName(QStringLiteral("graph"));
  setAccessibleName(QStringLiteral("System graph"));
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setTransformationAnchor(AnchorUnderMouse);
  setResizeAnchor(AnchorViewCenter);
  setViewportUpdateMode(SmartViewportUpdate);
  setMouseTracking(true);
  connect(&scene, &GraphScene::contentsMoved, this, &GraphView::follow);
  connect(&mode, &ConnectMode::changed, this, [this] {
    if (!mode_.active()) follow();
  });
}

std::optional<QPoint> GraphView::pointOf(const PortName& port) const {
  const PortItem* item = scene_.port(port);
  return item == nullptr ? std::nullopt : std::optional(mapFromScene(item->scenePos()));
}

void GraphView::fit() {
  following_ = true;
  showAll();
}

QRectF GraphView::seen() const { return mapToScene(viewport()->rect()).boundingRect(); }

void GraphView::follow() {
  const QRectF contents = scene_.contents();
  // Room around, so that every part can be moved to the middle.
  setSceneRect(contents.adjusted(
      -contents.width() - viewport()->width(), -contents.height() - viewport()->height(),
      contents.width() + viewport()->width(), contents.height() + viewport()->height()));
  const bool calm = mode_.active() || (handIsOnIt() && seen().contains(contents));
  if (following_ && !calm) showAll();
  scene_.setVisible(seen());
}

bool GraphView::handIsOnIt() const {
  return pointer_moved_.isValid() && !pointer_moved_.hasExpired(hand_rests_.count());
}

void GraphView::showAll() {
  const QRectF contents = scene_.contents().adjusted(-kMargin, -kMargin, kMargin, kMargin);
  if (scene_.contents().isEmpty()) return;
  const double wanted =
      std::min(viewport()->width() / contents.width(), viewport()->height() / contents.height());
  const double scale = std::clamp(wanted, kLeastScale, kMostFitted);
  setTransform(QTransform::fromScale(scale, scale));
  centerOn(contents.center());
  scene_.setVisible(seen());
}

void GraphView::zoom(double factor) {
  const double now = transform().m11();
  const double then = std::clamp(now * factor, kLeastScale, kMostScale);
  following_ = false;
  scale(then / now, then / now);
  scene_.setVisible(seen());
}

void GraphView::reveal(const QString& path) {
  if (const ComponentItem* item = scene_.component(path.section('/', 0, 1))) {
    ensureVisible(item->sceneRect(), 40, 40);
  }
}

std::optional<PortName> GraphView::portAt(const QPoint& position) const {
  // An edge that ends in the port, or its preview, may lie above it.
  for (const QGraphicsItem* item : items(position)) {
    if (const auto* port = qgraphicsitem_cast<const PortItem*>(item)) return port->port();
  }
  return std::nullopt;
}

void GraphView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton || event->button() == Qt::MiddleButton) {
    pressed_ = event->pos();
    pressed_port_ = portAt(event->pos());
    dragging_ = false;
  }
}

void GraphView::mouseMoveEvent(QMouseEvent* event) {
  // A window that appears under a pointer at rest hears of it once.
  if (pointer_ && *pointer_ != event->pos()) pointer_moved_.start();
  pointer_ = event->pos();
  if (!pressed_) {
    scene_.point(portAt(event->pos()));
    return QGraphicsView::mouseMoveEvent(event);
  }
  if (!dragging_ && !IsPan(event->pos() - *pressed_)) return;
  dragging_ = true;
  if (pressed_port_) {
    dragConnection(event->pos());
  } else {
    pan(event->pos());
  }
}

void GraphView::pan(const QPoint& position) {
  const QPoint moved = position - *pressed_;
  following_ = false;
  pressed_ = position;
  horizontalScrollBar()->setValue(horizontalScrollBar()->value() - moved.x());
  verticalScrollBar()->setValue(verticalScrollBar()->value() - moved.y());
  scene_.setVisible(seen());
}

void GraphView::dragConnection(const QPoint& position) {
  if (!mode_.active() || mode_.chosen() != *pressed_port_) {
    mode_.leave();
    mode_.start(*pressed_port_);
  }
  scene_.point(portAt(position));
}

void GraphView::mouseReleaseEvent(QMouseEvent* event) {
  const bool clicked = pressed_ && !dragging_ && event->button() == Qt::LeftButton;
  const bool connected = dragging_ && pressed_port_ && mode_.active();
  pressed_.reset();
  pressed_port_.reset();
  dragging_ = false;
  if (clicked) click(event->pos());
  if (!connected) return;
  // Dropped beside every port, the choice stays open for a click.
  if (const auto port = portAt(event->pos()); port && port != mode_.chosen()) mode_.pick(*port);
}

void GraphView::leaveEvent(QEvent* event) {
  pointer_.reset();
  pointer_moved_.invalidate();
  scene_.point(std::nullopt);
  QGraphicsView::leaveEvent(event);
  if (following_ && !mode_.active()) showAll();
}

void GraphView::click(const QPoint& position) {
  if (const auto port = portAt(position)) {
    if (mode_.active() && port != mode_.chosen() && port->side != mode_.chosen().side) {
      return mode_.pick(*port);
    }
    const bool again = mode_.active() && port == mode_.chosen();
    mode_.leave();
    selection_.select(ToQString(ToString(port->name)));
    if (!again) mode_.start(*port);
    return;
  }
  mode_.leave();
  QGraphicsItem* item = itemAt(position);
  if (const auto* component = qgraphicsitem_cast<ComponentItem*>(item)) {
    selection_.select(component->path());
  } else if (const auto* edge = qgraphicsitem_cast<EdgeItem*>(item)) {
    selection_.select(edge->required());
    if (edge->isBroken()) Q_EMIT whyRequested(edge->required());
  } else if (const auto* process = qgraphicsitem_cast<ProcessItem*>(item)) {
    selection_.select(process->name());
  } else {
    selection_.clear();
  }
}

void GraphView::wheelEvent(QWheelEvent* event) {
  zoom(std::pow(1.0015, event->angleDelta().y()));
  event->accept();
}

void GraphView::resizeEvent(QResizeEvent* event) {
  QGraphicsView::resizeEvent(event);
  follow();
  if (following_) showAll();
}

void GraphView::paintEvent(QPaintEvent* event) {
  QGraphicsView::paintEvent(event);
  PaintFocus(*this, viewport()->rect());
}

void GraphView::focusInEvent(QFocusEvent* event) {
  QGraphicsView::focusInEvent(event);
  viewport()->update();
}

void GraphView::focusOutEvent(QFocusEvent* event) {
  QGraphicsView::focusOutEvent(event);
  viewport()->update();
}

void GraphView::showEvent(QShowEvent* event) {
  QGraphicsView::showEvent(event);
  Q_EMIT seenChanged(true);
}

void GraphView::hideEvent(QHideEvent* event) {
  QGraphicsView::hideEvent(event);
  Q_EMIT seenChanged(false);
}

void GraphView::scrollContentsBy(int dx, int dy) {
  QGraphicsView::scrollContentsBy(dx, dy);
  if (HasKeyboardFocus(*this)) viewport()->update();  // else its frame would move along
}

bool GraphView::connectKey(int key) {
  if (!mode_.active()) return false;
  if (key >= Qt::Key_1 && key <= Qt::Key_9) {
    mode_.pickNumber(key - Qt::Key_0);
  } else if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    mode_.pickBest();
  } else if (key == Qt::Key_Escape) {
    mode_.leave();
  } else {
    return false;
  }
  return true;
}

void GraphView::keyPressEvent(QKeyEvent* event) {
  if (connectKey(event->key())) return;
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoomIn();
    case Qt::Key_Minus:
      return zoomOut();
    case Qt::Key_0:
      return fit();
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
      return selectNext(event->key());
    default:
      return QGraphicsView::keyPressEvent(event);
  }
}

void GraphView::selectNext(int key) {
  const ComponentItem* from = scene_.component(selection_.current().section('/', 0, 1));
  const QPointF here = from == nullptr ? QPointF() : from->sceneRect().center();
  const ComponentItem* best = nullptr;
  double least = 0;
  for (const auto& [path, item] : scene_.components()) {
    const QPointF way = item->sceneRect().center() - here;
    const bool sideways = key == Qt::Key_Left || key == Qt::Key_Right;
    const double sign = key == Qt::Key_Left || key == Qt::Key_Up ? -1 : 1;
    const double ahead = sign * (sideways ? way.x() : way.y());
    const double aside = std::abs(sideways ? way.y() : way.x());
    if (item == from || (from != nullptr && ahead < 4)) continue;
    const double cost = from == nullptr ? way.manhattanLength() : ahead + 2 * aside;
    if (best != nullptr && cost >= least) continue;
    best = item;
    least = cost;
  }
  if (best == nullptr) return;
  selection_.select(best->path());
  reveal(best->path());
}

}  // namespace tendon::gui
