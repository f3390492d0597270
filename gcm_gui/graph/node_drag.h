#pragma once

#include <QPointF>
#include <QString>
#include <map>

namespace tendon::gui {

class GraphScene;

/// A drag of a component, or of a process with all its components.
class NodeDrag {
 public:
  /// If `path` is neither a component nor a process, the drag moves nothing.
  NodeDrag(GraphScene& scene, const QString& path, const QPointF& from);

  /// Moves the dragged items with the pointer, which is now at `point` in the scene, and snaps them
  /// to the grid.
  void moveTo(const QPointF& point);
  /// Moves the dragged items to this offset from their original positions.
  void moveBy(const QPointF& way);
  /// Ends the drag. The whole drag is one step to undo; for `key` see NodePositions::move().
  void drop(const QString& key = {});
  /// Moves everything back to its original position.
  void cancel();

 private:
  [[nodiscard]] std::map<QString, QPointF> moved() const;

  GraphScene& scene_;
  QPointF from_;
  std::map<QString, QPointF> places_;  // original positions, by path
  QPointF way_;
};

}  // namespace tendon::gui
