#include <gcm_gui/plot/plot_marks.h>

#include <gcm_gui/plot/canvas/mark_flags.h>
#include <qwt_plot.h>
#include <qwt_scale_map.h>

namespace tendon::gui {

PlotMarks::PlotMarks(QwtPlot& plot, SharedTimeAxis& time_axis)
    : plot_(plot), time_axis_(time_axis) {}

void PlotMarks::set(const MarkTrack& marks) {
  delete flags_;  // the destructor of the flags detaches them from the plot
  flags_ = new MarkFlags(marks, time_axis_.window());
  flags_->attach(&plot_);
  time_axis_.touch();
}

void PlotMarks::setShown(bool shown) {
  if (flags_ != nullptr) flags_->setVisible(shown);
  time_axis_.touch();
}

bool PlotMarks::areShown() const { return flags_ != nullptr && flags_->isVisible(); }

QString PlotMarks::textAt(double x) const {
  if (!areShown()) return {};
  const TimeWindow& window = time_axis_.window();
  QwtScaleMap map = plot_.canvasMap(QwtAxis::XBottom);
  const double seconds = map.invTransform(x);
  const double shift = window.secondsAt(window.shownAt(seconds)) - seconds;
  map.setScaleInterval(map.s1() + shift, map.s2() + shift);
  return flags_->textAt(x, map, plot_.canvas()->contentsRect());
}

void PlotMarks::describe() {
  QWidget& canvas = *plot_.canvas();
  const TimeWindow& window = time_axis_.window();
  const QString text = areShown() && canvas.hasFocus()
                           ? flags_->textBetween(window.firstTime(), window.lastTime())
                           : QString();
  if (text != canvas.accessibleDescription()) canvas.setAccessibleDescription(text);
}

}  // namespace tendon::gui
