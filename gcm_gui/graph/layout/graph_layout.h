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

/// Where everything of a graph stands.
struct Arrangement {
  QHash<QString, QRectF> boxes;  ///< of processes, by name
  QHash<QString, QRectF> nodes;  ///< of components, by path; in the same coordinates
};

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

  std::map<QString, graph::ColumnLayout> insides_;  // of each process
  graph::ColumnLayout processes_;
  std::map<QString, QPointF> places_;  // by hand
  bool other_places_ = false;          // since the last update
  Arrangement arrangement_;
  std::vector<Affinity> affinities_;                 // the last ones, and sorted by process:
  std::map<QString, std::vector<Affinity>> inside_;  // between components of one
  std::vector<Affinity> across_;                     // between two
};

}  // namespace tendon::gui
