#pragma once

#include <gcm_gui/plot/controls/legend.h>

#include <QScrollArea>

class QwtPlot;

namespace tendon::gui {

/// Holds a plot's legend below the canvas, so that the legend does not cover a curve. Scrolls if
/// the legend is higher than the area.
class LegendArea : public QScrollArea {
  Q_OBJECT

 public:
  /// Creates a child of `plot`. The area sets the contents margins of the plot whenever the size of
  /// the legend or of the plot changes.
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
