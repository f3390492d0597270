#pragma once

#include <QPointF>
#include <QString>
#include <map>

namespace tendon::gui {

class GraphScene;

/// A drag of a component, or of a process with all its components.
class NodeDrag {
 public:
  /// Drags nothing if `path` is neither.
  NodeDrag(GraphScene& scene, const QString& path, const QPointF& from);

  /// Follows the pointer, which is now at `point` in the scene; snaps to the grid.
  void moveTo(const QPointF& point);
  /// Moves by this offset from the start.
  void moveBy(const QPointF& way);
  /// Ends the drag as one step to undo; see NodePositions::move().
  void drop(const QString& key = {});
  /// Returns everything to its original position.
  void cancel();

 private:
  [[nodiscard]] std::map<QString, QPointF> moved() const;

  GraphScene& scene_;
  QPointF from_;
  std::map<QString, QPointF> places_;  // original positions, by path
  QPointF way_;
};

}  // namespace tendon::gui
