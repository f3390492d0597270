#pragma once

#include <gcm_gui/plot/canvas/plot_axes.h>
#include <gcm_gui/plot/series/cursors.h>
#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/shared_time_axis.h>

#include <QObject>
#include <optional>

namespace tendon::gui {

/// Places the cursors by columns of the canvas of one plot. All plots with the same time axis have
/// the same cursors. `x` is in pixels of the canvas. GUI thread.
class PlotCursors : public QObject {
  Q_OBJECT

 public:
  /// All arguments must outlive this object.
  PlotCursors(const PlotAxes& axes, const CurveSet& curves, SharedTimeAxis& time_axis);

  /// Places a cursor at the time of column `x`, even in a live plot. Does nothing in an empty plot.
  void place(Cursor cursor, double x);
  /// Returns the cursor that is drawn within a few pixels of `x`.
  [[nodiscard]] std::optional<Cursor> at(double x) const;
  /// True places A and B in the middle of the view; false removes both.
  void show(bool shown);
  [[nodiscard]] const Cursors& times() const { return times_; }

 Q_SIGNALS:
  void shownChanged(bool shown);

 private:
  const PlotAxes& axes_;
  const CurveSet& curves_;
  SharedTimeAxis& time_axis_;
  Cursors& times_;  // belongs to the shared time axis
};

}  // namespace tendon::gui
