#include <gcm_gui/graph/node_drag.h>

#include <gcm_gui/graph/graph_scene.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/graph/layout/node_positions.h>
#include <gcm_gui/theme/metrics.h>

#include <cmath>

namespace tendon::gui {
namespace {

double OnGrid(double value) { return std::round(value / kGrid) * kGrid; }

}  // namespace

NodeDrag::NodeDrag(GraphScene& scene, const QString& path, const QPointF& from)
    : scene_(scene), from_(from) {
  for (const auto& [name, item] : scene.components()) {
    const bool is_carried = name == path || name.section('/', 0, 0) == path;
    if (is_carried) places_.emplace(name, item->sceneRect().topLeft());
  }
}

std::map<QString, QPointF> NodeDrag::moved() const {
  std::map<QString, QPointF> all;
  for (const auto& [path, place] : places_) all.emplace(path, place + way_);
  return all;
}

void NodeDrag::moveTo(const QPointF& point) { moveBy(point - from_); }

void NodeDrag::moveBy(const QPointF& way) {
  const QPointF on_grid(OnGrid(way.x()), OnGrid(way.y()));
  if (on_grid == way_) return;
  way_ = on_grid;
  scene_.carry(moved());
}

void NodeDrag::drop(const QString& key) {
  if (!way_.isNull()) scene_.nodePositions().move(moved(), key);
  scene_.carry({});
}

void NodeDrag::cancel() { scene_.carry({}); }

}  // namespace tendon::gui
