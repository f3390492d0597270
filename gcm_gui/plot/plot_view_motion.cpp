#include <gcm_gui/plot/plot_view.h>
#include <qwt_scale_map.h>

#include <algorithm>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr double kGrab = 5;  // pixels around a cursor

}  // namespace

void PlotView::setWindow(std::chrono::nanoseconds length) {
  window_.setLength(length);
  changed();
}

void PlotView::setMotion(TimeWindow::Motion motion) {
  window_.setMotion(motion);
  changed();
  Q_EMIT motionChanged();
}

void PlotView::setPaused(bool paused) {
  if (paused) {
    window_.follow(now(), columns() * devicePixelRatioF());
    window_.hold();
  } else {
    window_.goLive();
  }
  changed();
}

void PlotView::goLive() {
  if (!isLive() || !isFitted()) link_->remember(TimeLink::Gesture::kOnce);
  window_.goLive();
  for (UnitAxis& axis : curves_.axes()) axis.fitted = true;
  changed();
}

void PlotView::goLiveTogether() {
  if (!isLive()) {
    link_->remember(TimeLink::Gesture::kOnce);
    link_->fitAll();
    window_.goLive();
    return changed();
  }
  goLive();
}

bool PlotView::isLive() const { return window_.isLive(); }

bool PlotView::isFitted() const {
  const auto& axes = curves_.axes();
  return std::all_of(axes.begin(), axes.end(), [](const UnitAxis& axis) { return axis.fitted; });
}

bool PlotView::isFirst() const {
  return std::all_of(above_.begin(), above_.end(),
                     [](const auto& plot) { return plot == nullptr || plot->curves().empty(); });
}

void PlotView::zoomTime(double factor, double x) {
  link_->remember(TimeLink::Gesture::kZoomTime);
  window_.zoom(factor, invTransform(QwtAxis::XBottom, x));
  changed();
}

// Sets the range of an axis. Refuses a range that cannot be shown, and a range between two whole
// numbers, where the axis would have no labels.
void PlotView::choose(UnitAxis& axis, const AxisRange& range) const {
  constexpr double kNarrower = 1 - 1e-9;  // rounding changes a moved range by less
  const bool has_whole =
      curves_.scale() == ValueScale::kLinear && axis.numbers == NumberKind::kWhole;
  const bool is_between = has_whole && range.span() < std::min(1.0, axis.range.span() * kNarrower);
  if (IsShowable(range) && !is_between) axis.range = range;
  axis.fitted = false;
}

void PlotView::zoomValues(double factor, double y) {
  link_->remember(TimeLink::Gesture::kZoomValues);
  const QwtScaleMap map = canvasMap(QwtAxis::YLeft);
  const double at = (y - map.p1()) / (map.p2() - map.p1());  // of the height, from below
  for (UnitAxis& axis : curves_.axes()) {
    const double fixed = axis.range.low + at * axis.range.span();
    choose(axis, {.low = fixed + (axis.range.low - fixed) * factor,
                  .high = fixed + (axis.range.high - fixed) * factor});
  }
  changed();
}

void PlotView::panTime(double pixels) {
  link_->remember(TimeLink::Gesture::kMove);
  window_.pan((window_.to() - window_.from()) * pixels / columns());
  changed();
}

void PlotView::panValues(double pixels) {
  link_->remember(TimeLink::Gesture::kMove);
  for (UnitAxis& axis : curves_.axes()) {
    const double by = axis.range.span() * pixels / canvas()->height();
    choose(axis, {.low = axis.range.low + by, .high = axis.range.high + by});
  }
  changed();
}

void PlotView::zoomTo(const QRect& rect) {
  link_->remember(TimeLink::Gesture::kOnce);
  window_.show(invTransform(QwtAxis::XBottom, rect.left()),
               invTransform(QwtAxis::XBottom, rect.right()));
  const QwtScaleMap map = canvasMap(QwtAxis::YLeft);
  const auto part = [&](int y) { return (y - map.p1()) / (map.p2() - map.p1()); };
  for (UnitAxis& axis : curves_.axes()) {
    const AxisRange all = axis.range;
    choose(axis, {.low = all.low + part(rect.bottom()) * all.span(),
                  .high = all.low + part(rect.top()) * all.span()});
  }
  changed();
}

void PlotView::endRun() { link_->endRun(); }

void PlotView::goBack() {
  link_->goBack();
  noticeChange();
}

void PlotView::goForward() {
  link_->goForward();
  noticeChange();
}

bool PlotView::hasFormerView() const { return link_->hasFormer(); }

bool PlotView::hasLaterView() const { return link_->hasLater(); }

void PlotView::placeCursor(Cursor cursor, double x) {
  if (curves_.empty()) return;
  cursors_.set(cursor, window_.shownAt(invTransform(QwtAxis::XBottom, x)));
  changed();
  Q_EMIT cursorsChanged(true);
}

std::optional<Cursor> PlotView::cursorAt(double x) const {
  for (const Cursor cursor : kCursors) {
    const auto time = cursors_.time(cursor);
    if (time && std::abs(transform(QwtAxis::XBottom, window_.pointOf(*time)) - x) <= kGrab) {
      return cursor;
    }
  }
  return std::nullopt;
}

void PlotView::showCursors(bool shown) {
  cursors_.clear();
  if (shown) {
    placeCursor(Cursor::kA, columns() / 3);
    placeCursor(Cursor::kB, columns() * 2 / 3);
  }
  changed();
  Q_EMIT cursorsChanged(cursors_.any());
}

}  // namespace tendon::gui
