#pragma once

#include <gcm_gui/plot/canvas/outer_labels.h>
#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/series/time_window.h>

#include <QStringList>
#include <cstddef>
#include <vector>

class QwtPlot;

namespace tendon::gui {

/// Room for labels beside a canvas, in pixels.
struct SideRoom {
  int left = 0;
  int right = 0;

  bool operator==(const SideRoom&) const = default;
};

/// The axes of a plot: time at the bottom, the first unit on the left, up to three more on the
/// right. Their labels take constant room, so the canvas does not move. GUI thread.
class PlotAxes {
 public:
  static constexpr int kTop = 14;           ///< pixels above the canvas, for the units
  static constexpr int kSide = 46;          ///< labels of an axis, or the empty side without one
  static constexpr int kValueSteps = 7;     ///< maximum number of label steps
  static constexpr std::size_t kMost = 4;   ///< the maximum number of units with an axis
  static constexpr std::size_t kOfQwt = 2;  ///< of these, the axes that QwtPlot itself has

  /// Sets up the axes of `plot`, which must outlive this.
  explicit PlotAxes(QwtPlot& plot);

  void takeTheme();
  /// False hides the axes of an empty plot.
  void setVisible(bool visible);
  void showTime(const TimeWindow& window);
  void showValues(const std::vector<UnitAxis>& axes, ValueScale scale);
  /// The room that the labels need, without the minimum of setRoom().
  [[nodiscard]] SideRoom wantedRoom() const;
  /// Sets the minimum room, so that the canvases of several plots are aligned. Unused room stays
  /// empty.
  void setRoom(const SideRoom& least);
  /// Paints the parts that Qwt cannot: the units above the axes, and the outer axes.
  void paint(const std::vector<UnitAxis>& axes) const;

  /// The distance between two labels of the time axis, in s.
  [[nodiscard]] static double timeStep(const TimeWindow& window);

 private:
  void placeSides();

  QwtPlot& plot_;
  OuterLabels outer_;
  QStringList heads_;  // the texts above the axes
  SideRoom least_;
};

}  // namespace tendon::gui
