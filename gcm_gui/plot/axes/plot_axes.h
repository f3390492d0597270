#pragma once

#include <gcm_gui/plot/axes/outer_labels.h>
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

/// The axes of a plot: time below, the first unit at the left, up to three more at the right. What
/// they say takes as much room at every moment, so that the canvas stays where it is. GUI thread.
class PlotAxes {
 public:
  static constexpr int kTop = 14;           ///< pixels above the canvas, for the units
  static constexpr int kSide = 46;          ///< labels of an axis, and the empty side without one
  static constexpr int kValueSteps = 7;     ///< from label to label, at most
  static constexpr std::size_t kMost = 4;   ///< units that have an axis
  static constexpr std::size_t kOfQwt = 2;  ///< of them at QwtPlot's own places

  /// Sets up the axes of `plot`, which must outlive this.
  explicit PlotAxes(QwtPlot& plot);

  void takeTheme();
  /// None where there is nothing to show.
  void setVisible(bool visible);
  void showTime(const TimeWindow& window);
  void showValues(const std::vector<UnitAxis>& axes, ValueScale scale);
  /// The room that labels take, without what setRoom() asked for.
  [[nodiscard]] SideRoom wantedRoom() const;
  /// Takes at least so much, so that the canvases of several plots stand below each other. Room
  /// that is not needed stays empty.
  void setRoom(const SideRoom& least);
  /// What Qwt has no place for: the units above the axes, and the outer axes, on the plot itself.
  void paint(const std::vector<UnitAxis>& axes) const;

  /// From one label of the time axis to the next, in s.
  [[nodiscard]] static double timeStep(const TimeWindow& window);

 private:
  void placeSides();

  QwtPlot& plot_;
  OuterLabels outer_;
  QStringList heads_;  // above the axes
  SideRoom least_;
};

}  // namespace tendon::gui
