#include <gcm_gui/plot/canvas/plot_axes.h>

#include <gcm_gui/plot/canvas/axis_labels.h>
#include <gcm_gui/plot/series/axis_range.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <qwt_plot.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_div.h>
#include <qwt_scale_map.h>
#include <qwt_scale_widget.h>

#include <QFontMetrics>
#include <QMargins>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr std::array kValueAxes{QwtAxis::YLeft, QwtAxis::YRight};
constexpr std::array kAxes{QwtAxis::XBottom, QwtAxis::YLeft, QwtAxis::YRight};
constexpr int kTimeSteps = 6;

QwtScaleDiv Division(const AxisRange& range, const std::vector<double>& ticks) {
  return QwtScaleDiv(range.low, range.high, {}, {}, QList<double>(ticks.begin(), ticks.end()));
}

template <typename Labels>
Labels& LabelsOf(QwtPlot& plot, QwtAxisId axis) {
  return static_cast<Labels&>(*plot.axisScaleDraw(axis));
}

}  // namespace

PlotAxes::PlotAxes(QwtPlot& plot) : plot_(plot) {
  plot.plotLayout()->setCanvasMargin(0);
  plot.plotLayout()->setAlignCanvasToScales(true);
  plot.plotLayout()->setSpacing(0);
  plot.setContentsMargins(kGrid, 0, 0, 0);  // so that long labels do not touch the edge
  plot.setAxisScaleDraw(QwtAxis::XBottom, new TimeLabels);
  for (const auto axis : kValueAxes) {
    plot.setAxisScaleDraw(axis, new AxisLabels);
    plot.axisScaleDraw(axis)->setMinimumExtent(kSide);
  }
  // Reserves room for labels that extend beyond the ends of an axis, even if there are none now.
  // Otherwise the canvas would move when such a label appears.
  const QFontMetrics metrics(Theme::instance().small());
  const int across = metrics.horizontalAdvance("-00.000 s") / 2;
  const int along = (metrics.height() + 1) / 2;
  for (const auto axis : kAxes) {
    const int end = axis == QwtAxis::XBottom ? across : along;
    QwtScaleWidget& widget = *plot.axisWidget(axis);
    widget.setMargin(0);
    widget.setSpacing(0);
    widget.setMinBorderDist(end, end);
  }
}

void PlotAxes::takeTheme() {
  const Theme& theme = Theme::instance();
  LabelsOf<TimeLabels>(plot_, QwtAxis::XBottom).setColor(theme.color(Token::kDim));
  for (const auto axis : kAxes) {
    plot_.setAxisFont(axis, theme.small());
    plot_.axisWidget(axis)->update();
  }
}

void PlotAxes::setVisible(bool visible) {
  for (const auto axis : kAxes) plot_.setAxisVisible(axis, visible);
}

double PlotAxes::columns() const {
  const QwtScaleMap map = plot_.canvasMap(QwtAxis::XBottom);
  return std::max(1.0, map.p2() - map.p1());
}

double PlotAxes::screenColumns() const { return columns() * plot_.devicePixelRatioF(); }

int PlotAxes::rows() const { return plot_.canvas()->height(); }

double PlotAxes::secondsAt(double x) const { return plot_.invTransform(QwtAxis::XBottom, x); }

double PlotAxes::columnOf(double seconds) const {
  return plot_.transform(QwtAxis::XBottom, seconds);
}

double PlotAxes::fractionAt(double y) const {
  const QwtScaleMap map = plot_.canvasMap(QwtAxis::YLeft);
  return (y - map.p1()) / (map.p2() - map.p1());
}

double PlotAxes::rowOf(double fraction) const {
  const QwtScaleMap map = plot_.canvasMap(QwtAxis::YLeft);
  return map.p1() + fraction * (map.p2() - map.p1());
}

double PlotAxes::timeStep(const TimeWindow& window) {
  return NiceTimeStep(window.to() - window.from(), kTimeSteps);
}

void PlotAxes::showTime(const TimeWindow& window) {
  const double step = timeStep(window);
  const AxisRange range{.low = window.from(), .high = window.to()};
  auto& labels = LabelsOf<TimeLabels>(plot_, QwtAxis::XBottom);
  labels.setStep(step);
  if (labels.setLive(window.isLive() && !window.isSweeping()))
    plot_.axisWidget(QwtAxis::XBottom)->update();
  plot_.setAxisScaleDiv(QwtAxis::XBottom, Division(range, TicksOf(range, step)));
}

void PlotAxes::showValues(const std::vector<UnitAxis>& axes, ValueScale scale) {
  // If there is no second axis, the labels are not drawn, but the right axis keeps its width.
  plot_.axisScaleDraw(QwtAxis::YRight)
      ->enableComponent(QwtAbstractScaleDraw::Labels, axes.size() > 1);
  for (std::size_t i = 0; i < kValueAxes.size() && i < axes.size(); ++i) {
    const ValueTicks ticks = TicksOf(axes[i], scale, kValueSteps);
    auto& labels = LabelsOf<AxisLabels>(plot_, kValueAxes[i]);
    const bool are_new = labels.setTicks(ticks);
    plot_.setAxisScaleDiv(kValueAxes[i], Division(axes[i].range, ticks.places));
    const bool is_recolored = labels.setColor(AxisColor(axes, i));
    if (are_new || is_recolored) plot_.axisWidget(kValueAxes[i])->update();
  }
  QStringList heads;
  for (const UnitAxis& axis : axes) heads << HeadOf(axis);
  const bool is_outer_new = outer_.show(axes, scale);
  if (is_outer_new) placeSides();
  if (is_outer_new || heads != heads_) plot_.update();
  heads_ = heads;
}

AxisMargins PlotAxes::wantedRoom() const {
  const auto extent = [this](QwtAxisId axis) {
    return static_cast<int>(std::ceil(plot_.axisScaleDraw(axis)->extent(plot_.axisFont(axis))));
  };
  return {.left = extent(QwtAxis::YLeft), .right = extent(QwtAxis::YRight) + outer_.width()};
}

void PlotAxes::setRoom(const AxisMargins& least) {
  if (least == least_) return;
  least_ = least;
  placeSides();
}

// Adds the width of the outer axes, and the width that no label uses, to the margins of the plot.
void PlotAxes::placeSides() {
  plot_.axisScaleDraw(QwtAxis::YLeft)->setMinimumExtent(std::max(kSide, least_.left));
  const AxisMargins wanted = wantedRoom();
  QMargins margins = plot_.contentsMargins();
  margins.setRight(outer_.width() + std::max(0, least_.right - wanted.right));
  plot_.setContentsMargins(margins);
  plot_.updateLayout();
}

void PlotAxes::paint(const std::vector<UnitAxis>& axes) const {
  QPainter painter(&plot_);
  painter.setFont(Theme::instance().small());
  const QRect canvas = plot_.canvas()->geometry();
  const int outer_left = plot_.axisWidget(QwtAxis::YRight)->geometry().right() + 1;
  for (std::size_t i = 0; i < kValueAxes.size() && i < axes.size(); ++i) {
    const bool left = i == 0;
    const QRect place = left ? QRect(2 * kGrid, 0, canvas.width(), kTop)
                             : QRect(canvas.left(), 0, outer_left - canvas.left() - kGrid, kTop);
    painter.setPen(LabelsOf<AxisLabels>(plot_, kValueAxes[i]).color());
    painter.drawText(place, (left ? Qt::AlignLeft : Qt::AlignRight), HeadOf(axes[i]));
  }
  outer_.paint(painter, QRect(outer_left, canvas.top(), 1, canvas.height()));
  outer_.paintUnits(painter, outer_left, kTop);
}

}  // namespace tendon::gui
