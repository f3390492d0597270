#pragma once

#include <QPointF>
#include <QString>
#include <map>

namespace tendon::gui {

class GraphScene;

/// A component on its way to another place under the hand, or a process with all that it has.
class NodeDrag {
 public:
  /// Nothing is carried where `path` is neither.
  NodeDrag(GraphScene& scene, const QString& path, const QPointF& from);

  /// As the pointer is here now, in the scene; on the grid.
  void moveTo(const QPointF& point);
  /// By so much from where it began.
  void moveBy(const QPointF& way);
  /// It stays there; one step to take back, see GraphPlaces::move().
  void drop(const QString& key = {});
  /// Back to where it was.
  void cancel();

 private:
  [[nodiscard]] std::map<QString, QPointF> moved() const;

  GraphScene& scene_;
  QPointF from_;
  std::map<QString, QPointF> places_;  // before, by path
  QPointF way_;
};

}  // namespace tendon::gui
