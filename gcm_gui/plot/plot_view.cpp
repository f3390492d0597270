#include <gcm_gui/fence/fence.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/canvas/cursor_lines.h>
#include <gcm_gui/plot/canvas/curve_layer.h>
#include <gcm_gui/plot/canvas/gap_bands.h>
#include <gcm_gui/plot/canvas/sweep_painter.h>
#include <gcm_gui/plot/legend/legend_area.h>
#include <gcm_gui/plot/legend/legend_entries.h>
#include <gcm_gui/plot/marks/mark_flags.h>
#include <gcm_gui/plot/plot_navigator.h>
#include <gcm_gui/plot/plot_overlay.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/scaling/curve_editor.h>
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
#include <cmath>
#include <limits>
#include <utility>

namespace tendon::gui {
namespace {

constexpr int kFrame = 16;       // ms
constexpr int kLegendTicks = 6;  // frames between updates of its numbers
constexpr int kCurrentMark = 2;  // pixels at the left edge
constexpr auto kHint = QT_TRANSLATE_NOOP("Words", "Select a value and press P, or drag it here");

std::uint64_t NextId() {
  static std::uint64_t last = 0;
  return ++last;
}

std::int64_t LocalNow() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

PlotView::PlotView(QWidget* parent) : PlotView(std::make_shared<TimeLink>(), parent) {}

PlotView::PlotView(std::shared_ptr<TimeLink> link, QWidget* parent)
    : QwtPlot(parent),
      axes_(*this),
      link_(std::move(link)),
      window_(link_->window()),
      cursors_(link_->cursors()),
      id_(NextId()),
      newest_ns_(std::numeric_limits<std::int64_t>::min()) {
  link_->join(curves_);
  setAccessibleName(Words::tr("Plot"));
  setAcceptDrops(true);
  setSizePolicy(QSizePolicy::Expanding,
                QSizePolicy::Expanding);  // overrides QwtPlot's size hint
  setAutoReplot(false);
  build();
  takeTheme();
  curvesChanged();
  connect(&Theme::instance(), &Theme::changed, this, &PlotView::takeTheme);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &PlotView::refreshFenced);
}

PlotView::~PlotView() { link_->leave(curves_); }

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
  (new CursorLines(curves_, window_, cursors_))->attach(this);
  overlay_ = new PlotOverlay(canvas());
  legend_ = new LegendArea(*this);
  live_pill_ = new QPushButton(canvas());
  live_pill_->setObjectName("live");
  live_pill_->setFocusPolicy(Qt::TabFocus);
  SetRole(*live_pill_, "primary");
  live_pill_->hide();
  connect(live_pill_, &QPushButton::clicked, this, &PlotView::goLiveTogether);
  connect(&legendBox(), &Legend::dragRequested, this, &PlotView::startDrag);
  connect(&legendBox(), &Legend::removeRequested, this, &PlotView::curveRemovalRequested);
  connect(&legendBox(), &Legend::remapRequested, this, &PlotView::remapRequested);
  connect(&legendBox(), &Legend::lookRequested, this, &PlotView::askForLook);
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
  axes_.showValues(curves_.axes(), curves_.scale());
  updateLegend();
  if (curves_.empty()) replot();  // the timer is stopped
}

Curve& PlotView::addCurve(const CurveKey& key) {
  Curve& curve = curves_.add(key);
  curvesChanged();
  return curve;
}

std::unique_ptr<Curve> PlotView::takeCurve(const QString& path) {
  std::unique_ptr<Curve> curve = curves_.take(path);
  curvesChanged();
  return curve;
}

void PlotView::adoptCurve(std::unique_ptr<Curve> curve) {
  curves_.adopt(std::move(curve));
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
  changed();
  axes_.showTime(window_);
  axes_.showValues(curves_.axes(), curves_.scale());
  updateLegend();
  update();
}

void PlotView::setFit(Fit fit) {
  curves_.setFit(fit);
  changed();
}

void PlotView::setScale(ValueScale scale) {
  curves_.setScale(scale);
  link_->leave(curves_);  // ranges in the history belong to the other scale
  link_->join(curves_);
  changed();
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
  auto* editor = new CurveEditor(ShortName(path), asked->unit(), asked->look(), axes, this);
  connect(editor, &CurveEditor::accepted, this,
          [this, path](const CurveLook& look) { setLook(path, look); });
  const QPoint below = legend_->geometry().topLeft();
  editor->move(mapToGlobal(below - QPoint(0, editor->height() + kGrid)));
  editor->show();
}

void PlotView::setStatistics(bool shown) {
  statistics_ = shown;
  updateLegend();
}

void PlotView::setMarks(const MarkTrack& marks) {
  delete flags_;  // removes itself from the plot
  flags_ = new MarkFlags(marks, window_);
  flags_->attach(this);
  changed();
}

void PlotView::setMarksShown(bool shown) {
  if (flags_ != nullptr) flags_->setVisible(shown);
  changed();
}

QString PlotView::marksAt(double x) const {
  if (flags_ == nullptr || !flags_->isVisible()) return {};
  QwtScaleMap map = canvasMap(QwtAxis::XBottom);
  const double seconds = map.invTransform(x);
  const double shift = window_.secondsAt(window_.shownAt(seconds)) - seconds;
  map.setScaleInterval(map.s1() + shift, map.s2() + shift);
  return flags_->textAt(x, map, canvas()->contentsRect());
}

// A text for screen readers.
void PlotView::describeMarks() {
  const bool are_told = flags_ != nullptr && flags_->isVisible() && canvas()->hasFocus();
  const QString text =
      are_told ? flags_->textBetween(window_.firstTime(), window_.lastTime()) : QString();
  if (text != canvas()->accessibleDescription()) canvas()->setAccessibleDescription(text);
}

void PlotView::setHover(std::optional<int> x) {
  if (curves_.empty()) x = std::nullopt;
  if (link_->setHover(x)) updateLegend();
}

std::vector<SourceFigures> PlotView::figures() const { return curves_.figures(now()); }

void PlotView::setPlotsAbove(const std::vector<PlotView*>& plots) {
  above_.assign(plots.begin(), plots.end());
  changed();
}

void PlotView::setMarkedCurrent(bool marked) {
  is_marked_current_ = marked;
  update();
}

void PlotView::changed() {
  link_->touch();
  noticeChange();
}

// Called after a change of this plot, or of another plot with the same time.
void PlotView::noticeChange() {
  if (link_->revision() == seen_revision_) return;
  seen_revision_ = link_->revision();
  dirty_ = true;
  updateLive();
}

void PlotView::updateLive() {
  // The time is shared with other plots, the value axes are not.
  live_pill_->setVisible(!curves_.empty() && (isLive() ? !isFitted() : isFirst()));
  // "Fit" if the time is live, but value axes are not fitted.
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

std::int64_t PlotView::now() const { return link_->clock().now(LocalNow()); }

// The width of the time axis in columns; slightly different from the canvas.
double PlotView::columns() const {
  const QwtScaleMap map = canvasMap(QwtAxis::XBottom);
  return std::max(1.0, map.p2() - map.p1());
}

void PlotView::noticeSamples() {
  const std::int64_t newest = curves_.newestTime();
  if (newest == newest_ns_) return;
  newest_ns_ = newest;
  link_->clock().hear(newest, LocalNow());
  dirty_ = true;
}

// The visible part of the curves. A sweeping window also shows the end of the previous pass.
std::vector<SeenSlices> PlotView::seenSlices() const {
  const QwtScaleMap map = canvasMap(QwtAxis::XBottom);
  const QRect rect = canvas()->contentsRect();
  const double ratio = canvas()->devicePixelRatioF();
  std::vector<SeenSlices> seen{{.slices = layer_->slicesOf(map, rect, ratio)}};
  if (!window_.isSweeping()) return seen;
  QwtScaleMap former = map;
  const double length = window_.to() - window_.from();
  former.setScaleInterval(map.s1() - length, map.s2() - length);
  SeenSlices before{.slices = layer_->slicesOf(former, rect, ratio), .pass = Pass::kFormer};
  before.first =
      static_cast<std::size_t>(window_.head() / length * static_cast<double>(before.slices.count));
  seen.push_back(before);
  return seen;
}

/// If the computation throws, drawing would fail too, so the plot is covered.
void PlotView::refreshFenced() {
  if (!Fence::instance().isCovered(this)) {
    Fence::run(this, ViewWork::kDrawing, [this] { refresh(); });
  }
}

void PlotView::refresh() {
  noticeSamples();
  window_.follow(now(), columns() * devicePixelRatioF());
  noticeChange();
  const bool legend_is_due = ticks_++ % kLegendTicks == 0;
  if (legend_is_due || link_->hover() != shown_hover_) updateLegend();
  if (legend_is_due) noticeSideRoom();
  if (legend_is_due) describeMarks();
  if (window_ == drawn_window_ && !dirty_) return;
  drawn_window_ = window_;
  dirty_ = false;
  const auto start = std::chrono::steady_clock::now();
  axes_.showTime(window_);
  const std::vector<SeenSlices> seen = seenSlices();
  curves_.fitAxes(seen);
  const QStringList without = curves_.withoutPlace(seen);
  QStringList notes;
  if (!without.isEmpty()) {
    notes << Words::tr("0 and less has no place on this axis: ") + without.join(", ");
  }
  if (!curves_.beyondAxes().isEmpty()) {
    notes << Words::tr("far beyond this axis: ") + curves_.beyondAxes().join(", ");
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
  const SideRoom room = axes_.wantedRoom();
  if (room == side_room_) return;
  side_room_ = room;
  Q_EMIT sideRoomChanged();
}

void PlotView::drawItems(QPainter* painter, const QRectF& canvas_rect,
                         const QwtScaleMap maps[QwtAxis::AxisPositions]) const {
  Fence::run(const_cast<PlotView*>(this), ViewWork::kDrawing, [&] {
    if (!window_.isSweeping()) return QwtPlot::drawItems(painter, canvas_rect, maps);
    DrawSweep(*this, window_, *painter, canvas_rect, maps);
  });
}

void PlotView::drawCanvas(QPainter* painter) {
  painter->fillRect(canvas()->contentsRect(), Theme::instance().color(Token::kPanel));
  QwtPlot::drawCanvas(painter);
}

void PlotView::updateLegend() {
  shown_hover_ = link_->hover();
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
  legendBox().setEntries(
      LegendEntriesOf(curves_, at, statistics_ ? std::optional(seen) : std::nullopt));
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
  if (from.isEmpty()) {
    Q_EMIT curvesDropped(keys);
  } else if (from.toULongLong() != id_) {
    Q_EMIT curvesMoved(keys, from.toULongLong());
  }
}

void PlotView::startDrag(const QString& path) {
  const Curve* dragged = curve(path);
  if (dragged == nullptr) return;
  auto* signal = new QMimeData;
  signal->setData(kPathMimeType, EncodedPaths({{path, dragged->unit()}}));
  signal->setData(kPlotMimeType, QByteArray::number(qulonglong{id_}));
  auto* drag = new QDrag(this);
  drag->setMimeData(signal);
  drag->exec(Qt::MoveAction | Qt::CopyAction, Qt::MoveAction);
}

}  // namespace tendon::gui
