#pragma once

#include <gcm_gui/graph/layout/column_layout.h>
#include <gcm_gui/graph/layout/graph_picture.h>

#include <QHash>
#include <QRectF>
#include <QString>
#include <map>

namespace tendon::gui {

/// Where everything stands: processes in columns, and in each its components in columns. Stable: an
/// update moves only what it is about.
class GraphLayout {
 public:
  GraphLayout();

  void update(const GraphPicture& picture);

  [[nodiscard]] QRectF process(const QString& name) const { return processes_.rect(name); }
  /// Of a component, by path; in the same coordinates as the processes.
  [[nodiscard]] QRectF node(const QString& path) const { return nodes_.value(path); }

 private:
  void arrangeNodes(const ProcessPicture& process, const std::vector<Affinity>& affinities);

  std::map<QString, ColumnLayout> insides_;  // of each process
  ColumnLayout processes_;
  QHash<QString, QRectF> nodes_;
};

}  // namespace tendon::gui
