#pragma once

#include <gcm_gui/plot/controls/legend.h>

#include <QScrollArea>

class QwtPlot;

namespace tendon::gui {

/// Holds a plot's legend below the canvas, so that it covers no curve. Scrolls if there are more
/// curves than room.
class LegendArea : public QScrollArea {
  Q_OBJECT

 public:
  /// A child of `plot`. Sets the plot's contents margins whenever the legend or the plot changes
  /// its size.
  explicit LegendArea(QwtPlot& plot);

  [[nodiscard]] Legend& legend() { return *legend_; }
  /// Call it when the size of the plot has changed.
  void place();

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QwtPlot& plot_;
  Legend* legend_;
};

}  // namespace tendon::gui
