#pragma once

#include <gcm_gui/plot/series/mark_track.h>
#include <gcm_gui/plot/shared_time_axis.h>

#include <QString>

class QwtPlot;

namespace tendon::gui {

class MarkFlags;

/// The marks in one plot: the flags that draw them, and their texts for the mouse and for screen
/// readers. GUI thread.
class PlotMarks {
 public:
  /// Both arguments must outlive this object.
  PlotMarks(QwtPlot& plot, SharedTimeAxis& time_axis);

  /// Draws these marks, which must outlive the plot. After a later change of `marks`, call
  /// PlotView::requestRedraw().
  void set(const MarkTrack& marks);
  void setShown(bool shown);
  /// Returns the texts of the marks at canvas column `x`, one per line.
  [[nodiscard]] QString textAt(double x) const;
  /// Describes the visible marks for screen readers while the canvas has the focus.
  void describe();

 private:
  [[nodiscard]] bool areShown() const;

  QwtPlot& plot_;
  SharedTimeAxis& time_axis_;
  MarkFlags* flags_ = nullptr;  // the plot owns it
};

}  // namespace tendon::gui
