#pragma once

#include <gcm_gui/plot/canvas/outer_labels.h>
#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/series/time_window.h>

#include <QStringList>
#include <cstddef>
#include <vector>

class QwtPlot;

namespace tendon::gui {

/// The width of the labels beside a canvas, in pixels.
struct AxisMargins {
  int left = 0;
  int right = 0;

  bool operator==(const AxisMargins&) const = default;
};

/// The axes of a plot: time at the bottom, the first unit on the left, up to three more units on
/// the right. The width of the labels is constant, so the canvas does not move. GUI thread.
class PlotAxes {
 public:
  static constexpr int kTop = 14;           ///< pixels above the canvas, for the units
  static constexpr int kSide = 46;          ///< width of the labels, or of a side without an axis
  static constexpr int kValueSteps = 7;     ///< maximum number of label steps
  static constexpr std::size_t kMax = 4;    ///< maximum number of units that have an axis
  static constexpr std::size_t kOfQwt = 2;  ///< the number of these that QwtPlot itself has

  /// Sets up the axes of `plot`, which must outlive this object.
  explicit PlotAxes(QwtPlot& plot);

  void takeTheme();
  /// If false, hides the axes, because the plot is empty.
  void setVisible(bool visible);
  void showTime(const TimeWindow& window);
  void showValues(const std::vector<UnitAxis>& axes, ValueScale scale);
  /// Returns the width that the labels need, without the minimum of setRoom().
  [[nodiscard]] AxisMargins wantedRoom() const;
  /// Sets the minimum width of the labels, so that the canvases of several plots are aligned. A
  /// part that the labels do not need stays empty.
  void setRoom(const AxisMargins& least);
  /// Paints what Qwt cannot paint: the units above the axes, and the outer axes.
  void paint(const std::vector<UnitAxis>& axes) const;

  /// Returns the width of the time axis in columns. This width differs slightly from the width of
  /// the canvas.
  [[nodiscard]] double columns() const;
  /// Returns the same width in pixels of the screen.
  [[nodiscard]] double screenColumns() const;
  /// Returns the height of the canvas in rows.
  [[nodiscard]] int rows() const;
  /// Returns the position of canvas column `x` on the time axis, in s.
  [[nodiscard]] double secondsAt(double x) const;
  [[nodiscard]] double columnOf(double seconds) const;
  /// Returns the position of canvas row `y` as a fraction of the value axes, from their bottom.
  [[nodiscard]] double fractionAt(double y) const;
  [[nodiscard]] double rowOf(double fraction) const;

  /// Returns the distance between two labels of the time axis, in s.
  [[nodiscard]] static double timeStep(const TimeWindow& window);

 private:
  void placeSides();

  QwtPlot& plot_;
  OuterLabels outer_;
  QStringList heads_;  // texts above the axes
  AxisMargins least_;
};

}  // namespace tendon::gui
