#include <gcm_gui/plot/plot_view.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/canvas/cursor_lines.h>
#include <gcm_gui/plot/canvas/curve_layer.h>
#include <gcm_gui/plot/canvas/gap_bands.h>
#include <gcm_gui/plot/canvas/sweep_painter.h>
#include <gcm_gui/plot/controls/curve_editor.h>
#include <gcm_gui/plot/controls/legend_area.h>
#include <gcm_gui/plot/controls/legend_entries.h>
#include <gcm_gui/plot/controls/plot_navigator.h>
#include <gcm_gui/plot/controls/plot_overlay.h>
#include <gcm_gui/plot/series/shown_time.h>
#include <gcm_gui/plot/series/time_shift.h>
#include <gcm_gui/theme/icon.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_scale_map.h>

#include <QDrag>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <algorithm>
#include <limits>
#include <utility>

namespace tendon::gui {
namespace {

constexpr int kFrame = 16;       // ms
constexpr int kLegendTicks = 6;  // frames between two updates of the numbers in the legend
constexpr int kCurrentMark = 2;  // pixels at the left edge
constexpr auto kHint = QT_TRANSLATE_NOOP("Words", "Select a value and press P, or drag it here");

std::uint64_t NextId() {
  static std::uint64_t last = 0;
  return ++last;
}

}  // namespace

PlotView::PlotView(QWidget* parent) : PlotView(std::make_shared<SharedTimeAxis>(), parent) {}

PlotView::PlotView(std::shared_ptr<SharedTimeAxis> time_axis, QWidget* parent)
    : QwtPlot(parent),
      axes_(*this),
      time_axis_(std::move(time_axis)),
      window_(time_axis_->window()),
      gestures_(axes_, curves_, *time_axis_),
      recorded_curves_(axes_, curves_, *time_axis_),
      cursors_(axes_, curves_, *time_axis_),
      marks_(*this, *time_axis_),
      id_(NextId()),
      newest_ns_(std::numeric_limits<std::int64_t>::min()) {
  time_axis_->join(curves_);
  setAccessibleName(Words::tr("Plot"));
  setAcceptDrops(true);
  setSizePolicy(QSizePolicy::Expanding,
                QSizePolicy::Expanding);  // replaces the policy of QwtPlot
  setAutoReplot(false);
  build();
  takeTheme();
  curvesChanged();
  connect(&Theme::instance(), &Theme::changed, this, &PlotView::takeTheme);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &PlotView::refreshGuarded);
}

PlotView::~PlotView() { time_axis_->leave(curves_); }

void PlotView::build() {
  auto* canvas_widget = qobject_cast<QwtPlotCanvas*>(canvas());
  canvas_widget->setFrameStyle(QFrame::NoFrame);
  canvas_widget->setAutoFillBackground(false);
  canvas_widget->setCursor(Qt::ArrowCursor);
  canvas_widget->setFocusIndicator(QwtPlotCanvas::CanvasFocusIndicator);
  canvas_widget->setObjectName("canvas");
  canvas_widget->setAccessibleName(Words::tr("Plot canvas"));
  setFrameStyle(QFrame::NoFrame);
  grid_ = new QwtPlotGrid;
  grid_->attach(this);
  (new GapBands(curves_, window_))->attach(this);
  layer_ = new CurveLayer(curves_, window_);
  layer_->attach(this);
  (new CursorLines(curves_, window_, cursors_.times()))->attach(this);
  overlay_ = new PlotOverlay(canvas());
  legend_ = new LegendArea(*this);
  live_pill_ = new QPushButton(canvas());
  live_pill_->setObjectName("live");
  live_pill_->setFocusPolicy(Qt::TabFocus);
  SetRole(*live_pill_, "primary");
  live_pill_->hide();
  connect(live_pill_, &QPushButton::clicked, &gestures_, &PlotGestures::goLiveTogether);
  connect(&gestures_, &PlotGestures::changed, this, &PlotView::noticeChange);
  connect(&recorded_curves_, &RecordedCurves::editorRequested, this, &PlotView::askForLook);
  connect(&legendBox(), &Legend::dragRequested, this, &PlotView::startDrag);
  connect(&legendBox(), &Legend::removeRequested, this, &PlotView::curveRemovalRequested);
  connect(&legendBox(), &Legend::remapRequested, this, &PlotView::remapRequested);
  connect(&legendBox(), &Legend::lookRequested, this, &PlotView::askForLook);
  connect(&legendBox(), &Legend::toggled, this, [this](const QString& path) {
    if (Curve* toggled = curve(path)) toggled->setVisible(!toggled->isVisible());
    requestRedraw();
    updateLegend();
  });
  new PlotNavigator(*this);
}

Legend& PlotView::legendBox() { return legend_->legend(); }

void PlotView::takeTheme() {
  axes_.takeTheme();
  grid_->setPen(Theme::instance().color(Token::kLine), 0);
  requestRedraw();
  axes_.showValues(curves_.axes(), curves_.scale());
  updateLegend();
  if (curves_.empty()) replot();  // the timer does not redraw an empty plot
}

Curve& PlotView::addCurve(const CurveKey& key) {
  Curve& curve = curves_.add(key);
  recorded_curves_.takeShifts();
  curvesChanged();
  return curve;
}

std::unique_ptr<Curve> PlotView::takeCurve(const QString& path) {
  std::unique_ptr<Curve> curve = curves_.take(path);
  curvesChanged();
  return curve;
}

void PlotView::adoptCurve(std::unique_ptr<Curve> curve) {
  if (curve->isRecorded() && !recorded_curves_.isOnPage(curve->recording())) {
    time_axis_->setShift(curve->recording(), curve->shift());
  }
  curves_.adopt(std::move(curve));
  recorded_curves_.takeShifts();
  curvesChanged();
}

void PlotView::removeCurve(const QString& path) {
  if (curves_.remove(path)) curvesChanged();
}

void PlotView::curvesChanged() {
  const bool empty = curves_.empty();
  overlay_->setHint(empty ? Words::tr(kHint) : QString());
  grid_->setVisible(!empty);
  axes_.setVisible(!empty);
  const QString curves = Words::tr("%1 curves").arg(curves_.curves().size());
  setAccessibleDescription(empty ? Words::tr(kHint) : curves);
  if (isVisible() && !empty) timer_.start(kFrame);
  requestRedraw();
  axes_.showTime(window_);
  axes_.showValues(curves_.axes(), curves_.scale());
  updateLegend();
  update();
}

void PlotView::setFit(Fit fit) {
  curves_.setFit(fit);
  requestRedraw();
}

void PlotView::setScale(ValueScale scale) {
  curves_.setScale(scale);
  // Forgets the history of this plot, because its ranges belong to the other scale.
  time_axis_->leave(curves_);
  time_axis_->join(curves_);
  requestRedraw();
  updateLegend();
}

void PlotView::setLook(const QString& path, const CurveLook& look) {
  Curve* const shown = curve(path);
  if (shown == nullptr || shown->look() == look) return;
  curves_.setLook(*shown, look);
  curvesChanged();
}

void PlotView::setNames(const QString& path, const ValueNamesPointer& names) {
  Curve* const named = curve(path);
  if (named == nullptr || named->allNames() == names) return;
  curves_.setNames(*named, names);
  curvesChanged();
}

void PlotView::askForLook(const QString& path) {
  const Curve* const asked = curve(path);
  if (asked == nullptr) return;
  QStringList axes;
  for (const UnitAxis& axis : curves_.axes()) {
    if (!axis.unit.isEmpty()) axes << axis.unit;
  }
  const QString recording = asked->recording();
  const QString name = asked->isRecorded()
                           ? RecordingName(path) + QStringLiteral(" · ") + ShortName(path)
                           : ShortName(path);
  auto* editor = new CurveEditor(name, asked->unit(), asked->look(), axes, this);
  if (asked->isRecorded()) editor->addShift(recorded_curves_.shift(recording));
  connect(editor, &CurveEditor::accepted, this,
          [this, path](const CurveLook& look) { setLook(path, look); });
  connect(editor, &CurveEditor::shiftAccepted, this,
          [this, recording](qint64 shift_ns) { recorded_curves_.setShift(recording, shift_ns); });
  const QPoint below = legend_->geometry().topLeft();
  editor->move(mapToGlobal(below - QPoint(0, editor->height() + kGrid)));
  editor->show();
}

void PlotView::setStatistics(bool shown) {
  statistics_ = shown;
  updateLegend();
}

void PlotView::setHover(std::optional<int> x) {
  if (curves_.empty()) x = std::nullopt;
  if (time_axis_->setHover(x)) updateLegend();
}

void PlotView::setPlotsAbove(const std::vector<PlotView*>& plots) {
  above_.assign(plots.begin(), plots.end());
  requestRedraw();
}

void PlotView::setMarkedCurrent(bool marked) {
  is_marked_current_ = marked;
  update();
}

void PlotView::requestRedraw() {
  time_axis_->touch();
  noticeChange();
}

// Called after a change of this plot or of another plot with the same time axis.
void PlotView::noticeChange() {
  if (time_axis_->revision() == seen_revision_) return;
  seen_revision_ = time_axis_->revision();
  dirty_ = true;
  recorded_curves_.takeShifts();
  updateLive();
}

void PlotView::updateLive() {
  // The button is shown if the time or a value axis does not follow the data. The plots share the
  // time, so for the time only the first plot shows the button. Each plot has its own value axes.
  live_pill_->setVisible(!curves_.empty() && (isLive() ? !curves_.isFitted() : isFirst()));
  // The text is "Fit" if the time is live but a value axis is not fitted.
  live_pill_->setText(isLive() ? Words::tr("Fit") : Words::tr("Live"));
  live_pill_->setIcon(ThemeIcon(isLive() ? "fit" : "play", Token::kOnAccent));
  live_pill_->setAccessibleName(isLive() ? Words::tr("Fit the values again")
                                         : Words::tr("Follow live data again"));
  live_pill_->setToolTip(live_pill_->accessibleName() + Words::tr(" (double click)"));
  live_pill_->adjustSize();
  live_pill_->move(canvas()->width() - live_pill_->width() - 2 * kGrid, 2 * kGrid);
  if (was_live_ == isLive()) return;
  was_live_ = isLive();
  Q_EMIT liveChanged(was_live_);
}

void PlotView::noticeSamples() {
  const std::int64_t newest = curves_.newestTime();
  if (newest == newest_ns_) return;
  newest_ns_ = newest;
  dirty_ = true;
  const bool has_live_samples = newest != std::numeric_limits<std::int64_t>::min();
  if (has_live_samples) time_axis_->clock().update(newest, ShownTime());
}

// Returns the visible part of the curves. In a sweeping window, this includes the end of the
// previous pass.
std::vector<VisibleSlices> PlotView::visibleSlices() const {
  const QwtScaleMap map = canvasMap(QwtAxis::XBottom);
  const QRect rect = canvas()->contentsRect();
  const double ratio = canvas()->devicePixelRatioF();
  std::vector<VisibleSlices> seen{{.slices = layer_->slicesOf(map, rect, ratio)}};
  if (!window_.isSweeping()) return seen;
  QwtScaleMap former = map;
  const double length = window_.to() - window_.from();
  former.setScaleInterval(map.s1() - length, map.s2() - length);
  VisibleSlices before{.slices = layer_->slicesOf(former, rect, ratio), .pass = Pass::kFormer};
  before.first =
      static_cast<std::size_t>(window_.head() / length * static_cast<double>(before.slices.count));
  seen.push_back(before);
  return seen;
}

/// Redraws. If the computation throws an exception, drawing would fail too, so the plot is covered.
void PlotView::refreshGuarded() {
  if (!ExceptionGuard::instance().isCovered(this)) {
    ExceptionGuard::run(this, ViewWork::kDrawing, [this] { refresh(); });
  }
}

void PlotView::refresh() {
  noticeSamples();
  time_axis_->follow(axes_.screenColumns());
  noticeChange();
  const bool legend_is_due = ticks_++ % kLegendTicks == 0;
  if (legend_is_due || time_axis_->hover() != shown_hover_) updateLegend();
  if (legend_is_due) noticeSideRoom();
  if (legend_is_due) marks_.describe();
  if (window_ == drawn_window_ && !dirty_) return;
  drawn_window_ = window_;
  dirty_ = false;
  const auto start = std::chrono::steady_clock::now();
  axes_.showTime(window_);
  const std::vector<VisibleSlices> seen = visibleSlices();
  curves_.fitAxes(seen);
  const QStringList without = curves_.withoutPlace(seen);
  QStringList notes;
  if (!without.isEmpty()) {
    notes << Words::tr("values of 0 and below cannot be shown on this axis: ") + without.join(", ");
  }
  if (!curves_.beyondAxes().isEmpty()) {
    notes << Words::tr("far outside of this axis: ") + curves_.beyondAxes().join(", ");
  }
  overlay_->setNote(notes.join("; "));
  axes_.showValues(curves_.axes(), curves_.scale());
  replot();
  using Time = FrameGovernor::Time;
  governor_.drew(std::chrono::duration_cast<Time>(std::chrono::steady_clock::now() - start));
  const auto interval = std::chrono::ceil<std::chrono::milliseconds>(governor_.interval());
  if (timer_.isActive() && timer_.intervalAsDuration() != interval) timer_.start(interval);
}

void PlotView::noticeSideRoom() {
  const AxisMargins room = axes_.wantedRoom();
  if (room == side_room_) return;
  side_room_ = room;
  Q_EMIT sideRoomChanged();
}

void PlotView::drawItems(QPainter* painter, const QRectF& canvas_rect,
                         const QwtScaleMap maps[QwtAxis::AxisPositions]) const {
  ExceptionGuard::run(const_cast<PlotView*>(this), ViewWork::kDrawing, [&] {
    if (!window_.isSweeping()) return QwtPlot::drawItems(painter, canvas_rect, maps);
    DrawSweep(*this, window_, *painter, canvas_rect, maps);
  });
}

void PlotView::drawCanvas(QPainter* painter) {
  painter->fillRect(canvas()->contentsRect(), Theme::instance().color(Token::kPanel));
  QwtPlot::drawCanvas(painter);
}

void PlotView::updateLegend() {
  shown_hover_ = time_axis_->hover();
  std::optional<std::int64_t> at;
  if (shown_hover_ && !curves_.empty()) {
    const double seconds = invTransform(QwtAxis::XBottom, *shown_hover_);
    at = window_.shownAt(seconds);
    const int decimals = DecimalsOf(PlotAxes::timeStep(window_)) + 2;
    overlay_->setHairline(shown_hover_, QString::number(seconds, 'f', decimals) + " s");
  } else {
    overlay_->setHairline({});
  }
  const TimeSpan seen{.from_ns = window_.firstTime(), .to_ns = window_.lastTime()};
  legendBox().setEntries(LegendEntriesOf(curves_, at, seen, statistics_));
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
  requestRedraw();
}

void PlotView::paintEvent(QPaintEvent* event) {
  QwtPlot::paintEvent(event);
  if (!curves_.empty()) axes_.paint(curves_.axes());
  if (!is_marked_current_) return;
  QPainter painter(this);
  painter.fillRect(0, 0, kCurrentMark, height(), Theme::instance().color(Token::kAccent));
}

void PlotView::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasFormat(kPathMimeType)) event->acceptProposedAction();
}

void PlotView::dropEvent(QDropEvent* event) {
  const QList<CurveKey> keys = PathsIn(*event->mimeData());
  if (keys.isEmpty()) return;
  event->acceptProposedAction();
  const QByteArray from = event->mimeData()->data(kPlotMimeType);
  if (from.isEmpty() || RecordedMomentIn(*event->mimeData())) {
    // The other window has its shown moment at the right edge, so this plot also shows it there.
    const auto moment = RecordedMomentIn(*event->mimeData());
    const QString recording = RecordingOf(keys.front().path);
    if (moment && !recorded_curves_.isOnPage(recording)) {
      recorded_curves_.align(recording, MovedTime(*moment, -WallOffset()),
                             RecordedCurves::Edge::kRight);
    }
    Q_EMIT curvesDropped(keys);
  } else if (from.toULongLong() != id_) {
    Q_EMIT curvesMoved(keys, from.toULongLong());
  }
}

void PlotView::startDrag(const QString& path) {
  const Curve* dragged = curve(path);
  if (dragged == nullptr) return;
  auto* signal = new QMimeData;
  SetPaths(*signal, {{path, dragged->unit()}});
  signal->setData(kPlotMimeType, QByteArray::number(qulonglong{id_}));
  auto* drag = new QDrag(this);
  drag->setMimeData(signal);
  drag->exec(Qt::MoveAction | Qt::CopyAction, Qt::MoveAction);
}

void PlotView::setWindow(std::chrono::nanoseconds length) {
  window_.setLength(length);
  requestRedraw();
}

void PlotView::setMotion(TimeWindow::Motion motion) {
  window_.setMotion(motion);
  requestRedraw();
  Q_EMIT motionChanged();
}

void PlotView::setPaused(bool paused) {
  if (paused) {
    time_axis_->follow(axes_.screenColumns());
    window_.hold();
  } else {
    window_.goLive();
  }
  requestRedraw();
}

bool PlotView::isFirst() const {
  return std::all_of(above_.begin(), above_.end(),
                     [](const auto& plot) { return plot == nullptr || plot->curves().empty(); });
}

}  // namespace tendon::gui
