#include <gcm_gui/plot/plot_gestures.h>

#include <algorithm>

namespace tendon::gui {
namespace {

using Gesture = SharedTimeAxis::Gesture;

}  // namespace

PlotGestures::PlotGestures(const PlotAxes& axes, CurveSet& curves, SharedTimeAxis& time_axis)
    : axes_(axes), curves_(curves), time_axis_(time_axis), window_(time_axis.window()) {}

void PlotGestures::zoomTime(double factor, double x) {
  time_axis_.remember(Gesture::kZoomTime);
  window_.zoom(factor, axes_.secondsAt(x));
  finish();
}

// Sets the range of an axis. Refuses a range that cannot be shown, and a range between two whole
// numbers, because the axis would have no labels there.
void PlotGestures::choose(UnitAxis& axis, const AxisRange& range) const {
  // If a range was only moved, rounding changes its span by less than this.
  constexpr double kNarrower = 1 - 1e-9;
  const bool has_whole =
      curves_.scale() == ValueScale::kLinear && axis.numbers == NumberKind::kWhole;
  const bool is_between = has_whole && range.span() < std::min(1.0, axis.range.span() * kNarrower);
  if (IsShowable(range) && !is_between) axis.range = range;
  axis.fitted = false;
}

void PlotGestures::zoomValues(double factor, double y) {
  time_axis_.remember(Gesture::kZoomValues);
  const double at = axes_.fractionAt(y);
  for (UnitAxis& axis : curves_.axes()) {
    const double fixed = axis.range.low + at * axis.range.span();
    choose(axis, {.low = fixed + (axis.range.low - fixed) * factor,
                  .high = fixed + (axis.range.high - fixed) * factor});
  }
  finish();
}

void PlotGestures::panTime(double pixels) {
  time_axis_.remember(Gesture::kMove);
  window_.pan((window_.to() - window_.from()) * pixels / axes_.columns());
  finish();
}

void PlotGestures::panValues(double pixels) {
  time_axis_.remember(Gesture::kMove);
  for (UnitAxis& axis : curves_.axes()) {
    const double by = axis.range.span() * pixels / axes_.rows();
    choose(axis, {.low = axis.range.low + by, .high = axis.range.high + by});
  }
  finish();
}

void PlotGestures::zoomTo(const QRect& rect) {
  time_axis_.remember(Gesture::kOnce);
  window_.show(axes_.secondsAt(rect.left()), axes_.secondsAt(rect.right()));
  for (UnitAxis& axis : curves_.axes()) {
    const AxisRange all = axis.range;
    choose(axis, {.low = all.low + axes_.fractionAt(rect.bottom()) * all.span(),
                  .high = all.low + axes_.fractionAt(rect.top()) * all.span()});
  }
  finish();
}

void PlotGestures::goLive() {
  if (!window_.isLive() || !curves_.isFitted()) time_axis_.remember(Gesture::kOnce);
  window_.goLive();
  curves_.fitAll();
  finish();
}

void PlotGestures::goLiveTogether() {
  if (window_.isLive()) return goLive();
  time_axis_.remember(Gesture::kOnce);
  time_axis_.fitAll();
  window_.goLive();
  finish();
}

void PlotGestures::goBack() {
  time_axis_.goBack();
  Q_EMIT changed();
}

void PlotGestures::goForward() {
  time_axis_.goForward();
  Q_EMIT changed();
}

void PlotGestures::finish() {
  time_axis_.touch();
  Q_EMIT changed();
}

}  // namespace tendon::gui
