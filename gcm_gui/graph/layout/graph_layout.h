#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>
#include <tendon/gcm/graph/column_layout.h>

#include <QHash>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <map>
#include <vector>

namespace tendon::gui {

/// Where everything stands: processes in columns, and in each its components in columns, except for
/// those that the user has put somewhere. Stable: an update moves only what it is about, and what
/// the user has put somewhere stays there; what is in its way steps aside.
class GraphLayout {
 public:
  GraphLayout();

  /// Whether anything stands elsewhere than before.
  bool update(const GraphPicture& picture);
  /// The left upper corners of components that stand where the user has put them, by path; from the
  /// next update() on.
  void setPlaces(std::map<QString, QPointF> places);

  [[nodiscard]] QRectF process(const QString& name) const { return boxes_.value(name); }
  /// Of a component, by path; in the same coordinates as the processes.
  [[nodiscard]] QRectF node(const QString& path) const { return nodes_.value(path); }

 private:
  void takeAffinities(const std::vector<Affinity>& affinities);
  bool arrangeNodes(const ProcessPicture& process);
  void placeAll(const GraphPicture& picture);
  [[nodiscard]] bool hasPlaced(const ProcessPicture& process) const;
  [[nodiscard]] QRectF columnRect(const QString& process) const;
  void placeNodes(const ProcessPicture& process, const QRectF& box);
  [[nodiscard]] QRectF placeByHand(const ProcessPicture& process);

  std::map<QString, graph::ColumnLayout> insides_;  // of each process
  graph::ColumnLayout processes_;
  std::map<QString, QPointF> places_;                // by hand
  bool other_places_ = false;                        // since the last update
  QHash<QString, QRectF> boxes_;                     // of processes, by name
  QHash<QString, QRectF> nodes_;                     // of components, by path
  std::vector<Affinity> affinities_;                 // the last ones, and sorted by process:
  std::map<QString, std::vector<Affinity>> inside_;  // between components of one
  std::vector<Affinity> across_;                     // between two
};

}  // namespace tendon::gui
