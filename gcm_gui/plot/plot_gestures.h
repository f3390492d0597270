#pragma once

#include <gcm_gui/plot/canvas/plot_axes.h>
#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/shared_time_axis.h>

#include <QObject>
#include <QRect>

namespace tendon::gui {

/// Zooms and moves the view of one plot, and goes through the history of views. The time belongs to
/// all plots with the same time axis, the value axes to this plot.
///
/// `x` and `y` are in pixels of the canvas. Zooming and moving end the live view; goBack() restores
/// it. GUI thread.
class PlotGestures : public QObject {
  Q_OBJECT

 public:
  /// All arguments must outlive this object.
  PlotGestures(const PlotAxes& axes, CurveSet& curves, SharedTimeAxis& time_axis);

  void zoomTime(double factor, double x);
  void zoomValues(double factor, double y);
  void panTime(double pixels);
  void panValues(double pixels);
  void zoomTo(const QRect& rect);
  /// Ends the present step of the history, so that the next gesture begins a new step; see
  /// SharedTimeAxis::Gesture.
  void endRun() { time_axis_.endRun(); }
  /// Makes the view live, and lets all axes follow the data.
  void goLive();
  /// Makes all plots with this time axis live, and lets all their axes follow the data.
  void goLiveTogether();

  // For goBack() and goForward() see SharedTimeAxis.
  void goBack();
  void goForward();
  [[nodiscard]] bool hasFormerView() const { return time_axis_.hasFormer(); }
  [[nodiscard]] bool hasLaterView() const { return time_axis_.hasLater(); }

 Q_SIGNALS:
  /// Emitted after each change of the view.
  void changed();

 private:
  void choose(UnitAxis& axis, const AxisRange& range) const;
  void finish();

  const PlotAxes& axes_;
  CurveSet& curves_;
  SharedTimeAxis& time_axis_;
  TimeWindow& window_;  // belongs to the shared time axis
};

}  // namespace tendon::gui
