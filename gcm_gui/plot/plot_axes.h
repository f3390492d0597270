#pragma once

#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/series/time_window.h>

#include <vector>

class QwtPlot;

namespace tendon::gui {

/// The axes of a plot: time below, the first unit at the left, the second at the right. What they
/// say takes as much room at every moment, so that the canvas stays where it is. GUI thread.
class PlotAxes {
 public:
  /// Sets up the axes of `plot`, which must outlive this.
  explicit PlotAxes(QwtPlot& plot);

  void takeTheme();
  /// None where there is nothing to show.
  void setVisible(bool visible);
  void showTime(const TimeWindow& window);
  void showValues(const std::vector<UnitAxis>& axes);
  /// Above the axes, on the plot itself.
  void paintUnits(const std::vector<UnitAxis>& axes) const;

  /// From one label of the time axis to the next, in s.
  [[nodiscard]] static double timeStep(const TimeWindow& window);
  static constexpr int kTop = 14;  ///< pixels above the canvas, for the units

 private:
  QwtPlot& plot_;
};

}  // namespace tendon::gui
