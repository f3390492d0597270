#include <gcm_gui/plot/canvas/cursor_lines.h>
#include <gcm_gui/plot/canvas/curve_layer.h>
#include <gcm_gui/plot/canvas/gap_bands.h>
#include <gcm_gui/plot/legend/legend_area.h>
#include <gcm_gui/plot/marks/mark_flags.h>
#include <gcm_gui/plot/plot_navigator.h>
#include <gcm_gui/plot/plot_overlay.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/rate_badge.h>
#include <gcm_gui/plot/series/statistics.h>
#include <gcm_gui/theme/icon.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_scale_map.h>

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tendon::gui {
namespace {

constexpr int kFrame = 16;       // ms
constexpr int kFigure = 8;       // characters of a number of the statistics
constexpr int kLegendTicks = 6;  // frames between two changes of its numbers
constexpr double kGrab = 5;      // pixels around a cursor
constexpr auto kHint = "Select a value and press P, or drag it here";

std::int64_t LocalNow() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

PlotView::PlotView(QWidget* parent)
    : QwtPlot(parent), axes_(*this), newest_ns_(std::numeric_limits<std::int64_t>::min()) {
  setAccessibleName("Plot");
  setAcceptDrops(true);
  setSizePolicy(QSizePolicy::Expanding,
                QSizePolicy::Expanding);  // QwtPlot would insist on its hint
  setAutoReplot(false);
  build();
  takeTheme();
  curvesChanged();
  connect(&Theme::instance(), &Theme::changed, this, &PlotView::takeTheme);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &PlotView::refresh);
}

void PlotView::build() {
  auto* canvas_widget = qobject_cast<QwtPlotCanvas*>(canvas());
  canvas_widget->setFrameStyle(QFrame::NoFrame);
  canvas_widget->setAutoFillBackground(false);
  canvas_widget->setCursor(Qt::ArrowCursor);
  canvas_widget->setFocusIndicator(QwtPlotCanvas::CanvasFocusIndicator);
  canvas_widget->setObjectName("canvas");
  canvas_widget->setAccessibleName("Plot canvas");
  setFrameStyle(QFrame::NoFrame);
  grid_ = new QwtPlotGrid;
  grid_->attach(this);
  (new GapBands(curves_, window_))->attach(this);
  layer_ = new CurveLayer(curves_, window_);
  layer_->attach(this);
  (new CursorLines(curves_, window_, cursors_))->attach(this);
  overlay_ = new PlotOverlay(canvas());
  legend_ = new LegendArea(*this);
  live_pill_ = new QPushButton(canvas());
  live_pill_->setObjectName("live");
  live_pill_->setFocusPolicy(Qt::TabFocus);
  SetRole(*live_pill_, "primary");
  live_pill_->hide();
  connect(live_pill_, &QPushButton::clicked, this, &PlotView::goLive);
  connect(&legendBox(), &Legend::removeRequested, this, &PlotView::curveRemovalRequested);
  connect(&legendBox(), &Legend::remapRequested, this, &PlotView::remapRequested);
  connect(&legendBox(), &Legend::toggled, this, [this](const QString& path) {
    if (Curve* toggled = curve(path)) toggled->setVisible(!toggled->isVisible());
    changed();
    updateLegend();
  });
  new PlotNavigator(*this);
}

Legend& PlotView::legendBox() { return legend_->legend(); }

void PlotView::takeTheme() {
  axes_.takeTheme();
  grid_->setPen(Theme::instance().color(Token::kLine), 0);
  changed();
  axes_.showValues(curves_.axes());
  updateLegend();
  if (curves_.empty()) replot();  // the timer stands still
}

Curve& PlotView::addCurve(const CurveKey& key) {
  Curve& curve = curves_.add(key);
  curvesChanged();
  return curve;
}

void PlotView::removeCurve(const QString& path) {
  if (curves_.remove(path)) curvesChanged();
}

void PlotView::curvesChanged() {
  const bool empty = curves_.empty();
  overlay_->setHint(empty ? kHint : "");
  grid_->setVisible(!empty);
  axes_.setVisible(!empty);
  setAccessibleDescription(empty ? kHint : QString("%1 curves").arg(curves_.curves().size()));
  if (isVisible() && !empty) timer_.start(kFrame);
  changed();
  axes_.showTime(window_);
  axes_.showValues(curves_.axes());
  updateLegend();
  update();
}

void PlotView::setWindow(std::chrono::nanoseconds length) {
  window_.setLength(length);
  changed();
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
  window_.goLive();
  for (UnitAxis& axis : curves_.axes()) axis.fitted = true;
  former_views_.clear();
  changed();
}

bool PlotView::isLive() const { return window_.isLive(); }

void PlotView::zoomTime(double factor, double x) {
  window_.zoom(factor, invTransform(QwtAxis::XBottom, x));
  changed();
}

void PlotView::zoomValues(double factor, double y) {
  const QwtScaleMap map = canvasMap(QwtAxis::YLeft);
  const double at = (y - map.p1()) / (map.p2() - map.p1());  // of the height, from below
  for (UnitAxis& axis : curves_.axes()) {
    const double fixed = axis.range.low + at * axis.range.span();
    axis.range = {.low = fixed + (axis.range.low - fixed) * factor,
                  .high = fixed + (axis.range.high - fixed) * factor};
    axis.fitted = false;
  }
  changed();
}

void PlotView::panTime(double pixels) {
  window_.pan((window_.to() - window_.from()) * pixels / columns());
  changed();
}

void PlotView::panValues(double pixels) {
  for (UnitAxis& axis : curves_.axes()) {
    const double by = axis.range.span() * pixels / canvas()->height();
    axis.range = {.low = axis.range.low + by, .high = axis.range.high + by};
    axis.fitted = false;
  }
  changed();
}

void PlotView::zoomTo(const QRect& rect) {
  remember();
  window_.show(invTransform(QwtAxis::XBottom, rect.left()),
               invTransform(QwtAxis::XBottom, rect.right()));
  const QwtScaleMap map = canvasMap(QwtAxis::YLeft);
  const auto part = [&](int y) { return (y - map.p1()) / (map.p2() - map.p1()); };
  for (UnitAxis& axis : curves_.axes()) {
    const AxisRange all = axis.range;
    axis.range = {.low = all.low + part(rect.bottom()) * all.span(),
                  .high = all.low + part(rect.top()) * all.span()};
    axis.fitted = false;
  }
  changed();
}

void PlotView::remember() { former_views_.push_back({window_, curves_.axes()}); }

void PlotView::goBack() {
  if (former_views_.empty()) return;
  const View former = std::move(former_views_.back());
  former_views_.pop_back();
  window_ = former.window;
  for (UnitAxis& axis : curves_.axes()) {
    for (const UnitAxis& there : former.axes) {
      if (there.unit == axis.unit) {
        axis.range = there.range;
        axis.fitted = there.fitted;
      }
    }
  }
  changed();
}

void PlotView::placeCursor(Cursor cursor, double x) {
  if (curves_.empty()) return;
  cursors_.set(cursor, window_.timeAt(invTransform(QwtAxis::XBottom, x)));
  changed();
  Q_EMIT cursorsChanged(true);
}

std::optional<Cursor> PlotView::cursorAt(double x) const {
  for (const Cursor cursor : kCursors) {
    const auto time = cursors_.time(cursor);
    if (time && std::abs(transform(QwtAxis::XBottom, window_.secondsAt(*time)) - x) <= kGrab) {
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

void PlotView::setFit(Fit fit) {
  curves_.setFit(fit);
  changed();
}

void PlotView::setStatistics(bool shown) {
  statistics_ = shown;
  updateLegend();
}

QString PlotView::figuresOf(const Curve& curve) const {
  if (!statistics_) return {};
  const auto found =
      StatisticsOf(curve.samples(), window_.timeAt(window_.from()), window_.timeAt(window_.to()));
  if (!found) return {};
  const AxisRange& range = curves_.axisOf(curve).range;
  const auto text = [&](double value) { return LegendValue(value, range).rightJustified(kFigure); };
  return QString("min%1  max%2  mean%3  σ%4  rms%5  p-p%6  %7")
      .arg(text(found->lowest), text(found->highest), text(found->mean), text(found->deviation),
           text(found->rms), text(found->span()), RateText(found->rate));
}

void PlotView::setMarks(const MarkTrack& marks) {
  delete flags_;  // leaves the plot by itself
  flags_ = new MarkFlags(marks, window_);
  flags_->attach(this);
  changed();
}

QString PlotView::marksAt(double x) const {
  if (flags_ == nullptr) return {};
  return flags_->textAt(x, canvasMap(QwtAxis::XBottom), canvas()->contentsRect());
}

void PlotView::setHover(std::optional<int> x) {
  if (x == hover_) return;
  hover_ = curves_.empty() ? std::nullopt : x;
  updateLegend();
}

std::vector<SourceFigures> PlotView::figures() const { return curves_.figures(now()); }

void PlotView::changed() {
  dirty_ = true;
  updateLive();
}

void PlotView::updateLive() {
  const auto& axes = curves_.axes();
  const bool fitted =
      std::all_of(axes.begin(), axes.end(), [](const UnitAxis& axis) { return axis.fitted; });
  live_pill_->setVisible(!curves_.empty() && !(isLive() && fitted));
  // Live already, only its values are not: then there is less to go back to.
  live_pill_->setText(isLive() ? "Fit" : "Live");
  live_pill_->setIcon(ThemeIcon(isLive() ? "fit" : "play", Token::kOnAccent));
  live_pill_->setAccessibleName(isLive() ? "Fit the values again" : "Follow live data again");
  live_pill_->setToolTip(live_pill_->accessibleName() + " (double click)");
  live_pill_->adjustSize();
  live_pill_->move(canvas()->width() - live_pill_->width() - 2 * kGrid, 2 * kGrid);
  if (was_live_ == isLive()) return;
  was_live_ = isLive();
  Q_EMIT liveChanged(was_live_);
}

std::int64_t PlotView::now() const { return clock_.now(LocalNow()); }

// As the time axis counts them; not quite the canvas' width.
double PlotView::columns() const {
  const QwtScaleMap map = canvasMap(QwtAxis::XBottom);
  return std::max(1.0, map.p2() - map.p1());
}

void PlotView::noticeSamples() {
  const std::int64_t newest = curves_.newestTime();
  if (newest == newest_ns_) return;
  newest_ns_ = newest;
  clock_.hear(newest, LocalNow());
  dirty_ = true;
}

void PlotView::refresh() {
  noticeSamples();
  const bool moved = window_.follow(now(), columns() * devicePixelRatioF());
  if (ticks_++ % kLegendTicks == 0) updateLegend();
  if (!moved && !std::exchange(dirty_, false)) return;
  dirty_ = false;
  const auto start = std::chrono::steady_clock::now();
  axes_.showTime(window_);
  curves_.fitAxes(layer_->slicesOf(canvasMap(QwtAxis::XBottom), canvas()->contentsRect(),
                                   canvas()->devicePixelRatioF()));
  axes_.showValues(curves_.axes());
  replot();
  using Time = FrameGovernor::Time;
  governor_.drew(std::chrono::duration_cast<Time>(std::chrono::steady_clock::now() - start));
  const auto interval = std::chrono::ceil<std::chrono::milliseconds>(governor_.interval());
  if (timer_.isActive() && timer_.intervalAsDuration() != interval) timer_.start(interval);
}

void PlotView::drawCanvas(QPainter* painter) {
  painter->fillRect(canvas()->contentsRect(), Theme::instance().color(Token::kPanel));
  QwtPlot::drawCanvas(painter);
}

void PlotView::updateLegend() {
  std::optional<std::int64_t> at;
  if (hover_) {
    const double seconds = invTransform(QwtAxis::XBottom, *hover_);
    at = window_.timeAt(seconds);
    const int decimals = DecimalsOf(PlotAxes::timeStep(window_)) + 2;
    overlay_->setHairline(hover_, QString::number(seconds, 'f', decimals) + " s");
  } else {
    overlay_->setHairline({});
  }
  std::vector<LegendEntry> entries;
  for (const auto& curve : curves_.curves()) {
    const std::optional<double> value = at ? curve->valueAt(*at) : curve->latestValue();
    const bool stale = curve->isStale() && !at;
    entries.push_back(
        {.path = curve->path(),
         .name = stale ? ShortName(curve->path()) + " · " + curve->staleReason()
                       : ShortName(curve->path()),
         .value = value && !stale ? LegendValue(*value, curves_.axisOf(*curve).range) : QString(),
         .unit = stale ? QString() : curve->unit(),
         .color_index = curve->colorIndex(),
         .stale = stale,
         .shown = curve->isVisible(),
         .figures = figuresOf(*curve)});
  }
  legendBox().setEntries(entries);
}

void PlotView::showEvent(QShowEvent* event) {
  QwtPlot::showEvent(event);
  if (!curves_.empty()) timer_.start(kFrame);
}

void PlotView::hideEvent(QHideEvent* event) {
  QwtPlot::hideEvent(event);
  timer_.stop();
}

void PlotView::resizeEvent(QResizeEvent* event) {
  QwtPlot::resizeEvent(event);
  legend_->place();
  changed();
}

void PlotView::paintEvent(QPaintEvent* event) {
  QwtPlot::paintEvent(event);
  axes_.paintUnits(curves_.axes());
}

void PlotView::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasFormat(kPathMimeType)) event->acceptProposedAction();
}

void PlotView::dropEvent(QDropEvent* event) {
  const QList<CurveKey> keys = PathsIn(*event->mimeData());
  if (keys.isEmpty()) return;
  event->acceptProposedAction();
  Q_EMIT curvesDropped(keys);
}

}  // namespace tendon::gui
