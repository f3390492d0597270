#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>
#include <tendon/gcm/graph/column_layout.h>

#include <QHash>
#include <QRectF>
#include <QString>
#include <map>
#include <vector>

namespace tendon::gui {

/// Where everything stands: processes in columns, and in each its components in columns. Stable: an
/// update moves only what it is about.
class GraphLayout {
 public:
  GraphLayout();

  /// Whether anything stands elsewhere than before.
  bool update(const GraphPicture& picture);

  [[nodiscard]] QRectF process(const QString& name) const;
  /// Of a component, by path; in the same coordinates as the processes.
  [[nodiscard]] QRectF node(const QString& path) const { return nodes_.value(path); }

 private:
  void takeAffinities(const std::vector<Affinity>& affinities);
  bool arrangeNodes(const ProcessPicture& process);
  void placeNodes(const GraphPicture& picture);

  std::map<QString, graph::ColumnLayout> insides_;  // of each process
  graph::ColumnLayout processes_;
  QHash<QString, QRectF> nodes_;
  std::vector<Affinity> affinities_;                 // the last ones, and sorted by process:
  std::map<QString, std::vector<Affinity>> inside_;  // between components of one
  std::vector<Affinity> across_;                     // between two
};

}  // namespace tendon::gui
