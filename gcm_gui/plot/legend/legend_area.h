#pragma once

#include <gcm_gui/plot/legend/legend.h>

#include <QScrollArea>

class QwtPlot;

namespace tendon::gui {

/// Where the legend of a plot has its place: below the canvas, so that it covers no curve. Scrolls
/// when there are more curves than room.
class LegendArea : public QScrollArea {
  Q_OBJECT

 public:
  /// Sets the contents margins of `plot`, whose child it is, anew whenever the legend or the plot
  /// has another size.
  explicit LegendArea(QwtPlot& plot);

  [[nodiscard]] Legend& legend() { return *legend_; }
  /// To be called when the plot has another size.
  void place();

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QwtPlot& plot_;
  Legend* legend_;
};

}  // namespace tendon::gui
