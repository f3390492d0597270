#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>
#include <tendon/gcm/column_layout.h>

#include <QHash>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <map>
#include <vector>

namespace tendon::gui {

/// The positions of all items of a graph.
struct Arrangement {
  QHash<QString, QRectF> boxes;  ///< boxes of processes, by name
  QHash<QString, QRectF> nodes;  ///< nodes of components, by path; in the same coordinates
};

/// Arranges processes in columns, and the components of each process in columns. A component that
/// the user has placed stays at its position, and the others make room for it. The layout is
/// stable: an update moves only the items that it affects.
class GraphLayout {
 public:
  GraphLayout();

  /// Returns true if any position has changed.
  bool update(const GraphPicture& picture);
  /// Sets the positions (top left corners) of the components that the user has placed, by path.
  /// Takes effect at the next update().
  void setPlaces(std::map<QString, QPointF> places);

  [[nodiscard]] const Arrangement& arrangement() const { return arrangement_; }
  [[nodiscard]] QRectF process(const QString& name) const { return arrangement_.boxes.value(name); }
  [[nodiscard]] QRectF node(const QString& path) const { return arrangement_.nodes.value(path); }

 private:
  void takeAffinities(const std::vector<Affinity>& affinities);
  bool arrangeNodes(const ProcessPicture& process);
  void placeAll(const GraphPicture& picture);
  [[nodiscard]] bool hasPlaced(const ProcessPicture& process) const;
  [[nodiscard]] QRectF columnRect(const QString& process) const;
  void placeNodes(const ProcessPicture& process, const QRectF& box);
  [[nodiscard]] QRectF placeByHand(const ProcessPicture& process);

  std::map<QString, graph::ColumnLayout> insides_;  // the layout within each process
  graph::ColumnLayout processes_;
  std::map<QString, QPointF> places_;  // positions chosen by the user
  bool other_places_ = false;          // places_ has changed since the last update
  Arrangement arrangement_;
  std::vector<Affinity> affinities_;  // affinities of the last update; below: by process
  std::map<QString, std::vector<Affinity>> inside_;  // affinities within one process
  std::vector<Affinity> across_;                     // affinities between two processes
};

}  // namespace tendon::gui
