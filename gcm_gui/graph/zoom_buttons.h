#pragma once

#include <QWidget>

namespace tendon::gui {

class GraphView;

/// The buttons "−", "+" and "fit" in the lower right corner of the graph.
class ZoomButtons : public QWidget {
  Q_OBJECT

 public:
  explicit ZoomButtons(GraphView& graph);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void moveToCorner();
};

}  // namespace tendon::gui
