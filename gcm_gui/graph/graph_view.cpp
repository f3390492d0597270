#include <gcm_gui/graph/graph_view.h>

#include <gcm_gui/graph/graph_hover.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/items/port_item.h>
#include <gcm_gui/graph/items/process_item.h>
#include <gcm_gui/graph/layout/node_metrics.h>
#include <gcm_gui/graph/node_drag.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>
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

constexpr double kMinScale = 0.08;
constexpr double kMaxScale = 2.5;
constexpr double kReadable = 0.6;
// The largest scale of fit(), so that a small graph is not enlarged too much in a large window.
constexpr double kMaxFitted = 1.2;
constexpr double kMargin = 12;
constexpr int kPanStep = 60;          // pixels
constexpr int kMoveStep = 2 * kGrid;  // scene units

bool IsPan(const QPoint& moved) {
  return moved.manhattanLength() >= QApplication::startDragDistance();
}

/// Returns the direction of an arrow key; zero for all other keys.
QPoint WayOf(int key) {
  switch (key) {
    case Qt::Key_Left:
      return {-1, 0};
    case Qt::Key_Right:
      return {1, 0};
    case Qt::Key_Up:
      return {0, -1};
    case Qt::Key_Down:
      return {0, 1};
    default:
      return {};
  }
}

}  // namespace

GraphView::GraphView(GraphScene& scene, Selection& selection, ConnectMode& mode,
                     std::chrono::milliseconds pointer_timeout, QWidget* parent)
    : QGraphicsView(&scene, parent),
      scene_(scene),
      selection_(selection),
      mode_(mode),
      pointer_timeout_(pointer_timeout) {
  setObjectName(QStringLiteral("graph"));
  setAccessibleName(Words::tr("System graph"));
  setFrameShape(QFrame::NoFrame);
  setAcceptDrops(false);  // by default, the view would keep drops from the window
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
  // Makes the scene rectangle larger than the contents, so that every part can be centred.
  setSceneRect(contents.adjusted(
      -contents.width() - viewport()->width(), -contents.height() - viewport()->height(),
      contents.width() + viewport()->width(), contents.height() + viewport()->height()));
  const bool calm = mode_.active() || (isPointerMoving() && seen().contains(contents));
  if (following_ && !calm) showAll();
  updateVisibleArea();
}

void GraphView::updateVisibleArea() {
  scene_.setVisible(seen());
  Q_EMIT moved();
}

std::vector<InterfaceName> GraphView::visibleConnections() const {
  const QRectF now = seen();
  std::vector<InterfaceName> names;
  for (const auto& [key, edge] : scene_.edges()) {
    if (edge->look() != EdgeItem::Look::kActive) continue;
    if (edge->sceneBoundingRect().intersects(now)) names.push_back(edge->name());
  }
  return names;
}

void GraphView::lookAt(const QPointF& point) {
  following_ = false;
  centerOn(point);
  updateVisibleArea();
}

bool GraphView::isPointerMoving() const {
  return pointer_moved_.isValid() && !pointer_moved_.hasExpired(pointer_timeout_.count());
}

void GraphView::showAll() {
  const QRectF contents = scene_.contents().adjusted(-kMargin, -kMargin, kMargin, kMargin);
  if (scene_.contents().isEmpty()) return;
  const double wanted =
      std::min(viewport()->width() / contents.width(), viewport()->height() / contents.height());
  const double scale = std::clamp(wanted, kMinScale, kMaxFitted);
  setTransform(QTransform::fromScale(scale, scale));
  centerOn(contents.center());
  updateVisibleArea();
}

void GraphView::zoom(double factor) {
  const double now = transform().m11();
  const double then = std::clamp(now * factor, kMinScale, kMaxScale);
  following_ = false;
  scale(then / now, then / now);
  updateVisibleArea();
}

void GraphView::goTo(const QString& path) {
  selection_.select(path);
  const ComponentItem* item = scene_.component(path.section('/', 0, 1));
  if (item == nullptr) return;
  const double scale = std::max(transform().m11(), kReadable);
  setTransform(QTransform::fromScale(scale, scale));
  lookAt(item->sceneRect().center());
}

void GraphView::reveal(const QString& path) {
  if (const ComponentItem* item = scene_.component(path.section('/', 0, 1))) {
    ensureVisible(item->sceneRect(), 40, 40);
    updateVisibleArea();
  }
}

std::optional<PortName> GraphView::portAt(const QPoint& position) const {
  // Looks at all items here, because an edge or a preview may lie above the port.
  for (const QGraphicsItem* item : items(position)) {
    if (const auto* port = qgraphicsitem_cast<const PortItem*>(item)) return port->port();
  }
  return std::nullopt;
}

QString GraphView::pathAt(const QPoint& position) const {
  if (const auto port = portAt(position)) return ToQString(ToString(port->name));
  const QGraphicsItem* item = itemAt(position);
  if (const auto* component = qgraphicsitem_cast<const ComponentItem*>(item)) {
    return component->path();
  }
  const auto* edge = qgraphicsitem_cast<const EdgeItem*>(item);
  return edge == nullptr ? QString() : edge->required();
}

QString GraphView::nodeAt(const QPoint& position) const {
  if (mode_.active() || portAt(position)) return {};
  const QGraphicsItem* item = itemAt(position);
  if (const auto* component = qgraphicsitem_cast<const ComponentItem*>(item)) {
    return component->path();
  }
  const auto* process = qgraphicsitem_cast<const ProcessItem*>(item);
  if (process == nullptr) return {};
  const double below = mapToScene(position).y() - process->scenePos().y();
  return below < kProcessHead ? process->name() : QString();
}

void GraphView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton || event->button() == Qt::MiddleButton) {
    pressed_ = event->pos();
    pressed_port_ = portAt(event->pos());
    pressed_node_ = event->button() == Qt::LeftButton ? nodeAt(event->pos()) : QString();
    dragging_ = false;
  }
}

void GraphView::mouseMoveEvent(QMouseEvent* event) {
  // When a window appears under a resting pointer, the view receives one move event. Ignores this
  // event.
  if (pointer_ && *pointer_ != event->pos()) pointer_moved_.start();
  pointer_ = event->pos();
  if (!pressed_) {
    scene_.point(portAt(event->pos()));
    scene_.hover().point(pathAt(event->pos()));
    return QGraphicsView::mouseMoveEvent(event);
  }
  if (!dragging_ && !IsPan(event->pos() - *pressed_)) return;
  if (!dragging_) beginDrag();
  if (pressed_port_) {
    dragConnection(event->pos());
  } else if (node_drag_) {
    node_drag_->moveTo(mapToScene(event->pos()));
  } else if (pressed_node_.isEmpty()) {
    pan(event->pos());
  }
}

void GraphView::beginDrag() {
  dragging_ = true;
  scene_.hover().pointNow({});
  if (pressed_port_ || pressed_node_.isEmpty()) return;
  following_ = false;
  node_drag_.emplace(scene_, pressed_node_, mapToScene(*pressed_));
}

bool GraphView::cancelDrag() {
  if (!node_drag_) return false;
  node_drag_->cancel();
  node_drag_.reset();
  return true;
}

void GraphView::pan(const QPoint& position) {
  const QPoint moved = position - *pressed_;
  pressed_ = position;
  scrollBy(moved);
}

void GraphView::scrollBy(const QPoint& pixels) {
  following_ = false;
  horizontalScrollBar()->setValue(horizontalScrollBar()->value() - pixels.x());
  verticalScrollBar()->setValue(verticalScrollBar()->value() - pixels.y());
  updateVisibleArea();
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
  if (node_drag_) node_drag_->drop();
  node_drag_.reset();
  pressed_.reset();
  pressed_port_.reset();
  pressed_node_.clear();
  dragging_ = false;
  if (clicked) click(event->pos());
  if (!connected) return;
  // If the user has released the button outside of all ports, the mode stays active, so that a
  // click can complete the connection.
  if (const auto port = portAt(event->pos()); port && port != mode_.chosen()) mode_.pick(*port);
}

void GraphView::leaveEvent(QEvent* event) {
  pointer_.reset();
  pointer_moved_.invalidate();
  scene_.point(std::nullopt);
  scene_.hover().point({});
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
  scene_.hover().point({});
  viewport()->update();
}

void GraphView::showEvent(QShowEvent* event) {
  QGraphicsView::showEvent(event);
  Q_EMIT visibilityChanged(true);
}

void GraphView::hideEvent(QHideEvent* event) {
  QGraphicsView::hideEvent(event);
  Q_EMIT visibilityChanged(false);
}

void GraphView::scrollContentsBy(int dx, int dy) {
  QGraphicsView::scrollContentsBy(dx, dy);
  // Scrolling also moves the frame of the keyboard focus, so the whole view must be drawn again.
  if (HasKeyboardFocus(*this)) viewport()->update();
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

bool GraphView::panKey(const QKeyEvent& event) {
  const QPoint way = WayOf(event.key());
  if (event.modifiers() != Qt::ShiftModifier || way.isNull()) return false;
  scrollBy(-way * kPanStep);
  return true;
}

bool GraphView::moveKey(const QKeyEvent& event) {
  const QPoint way = WayOf(event.key());
  if (event.modifiers() != Qt::AltModifier || way.isNull()) return false;
  const QString path = selection_.current().section('.', 0, 0).section('/', 0, 1);
  if (path.isEmpty()) return false;
  NodeDrag drag(scene_, path, {});
  drag.moveBy(way * kMoveStep);
  following_ = false;
  drag.drop(QStringLiteral("keys ") + path);
  return true;
}

void GraphView::keyPressEvent(QKeyEvent* event) {
  if (connectKey(event->key()) || panKey(*event) || moveKey(*event)) return;
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
  scene_.hover().pointNow(best->path());
}

}  // namespace tendon::gui
