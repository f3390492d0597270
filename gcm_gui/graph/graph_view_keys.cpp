#include <gcm_gui/graph/emphasis/graph_hover.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/places/node_drag.h>
#include <gcm_gui/theme/metrics.h>

#include <QKeyEvent>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr int kPanStep = 60;          // pixels
constexpr int kMoveStep = 2 * kGrid;  // scene units

/// The direction of an arrow key; zero for other keys.
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
