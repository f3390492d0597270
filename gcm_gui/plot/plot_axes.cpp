#include <gcm_gui/plot/canvas/axis_labels.h>
#include <gcm_gui/plot/plot_axes.h>
#include <gcm_gui/plot/series/axis_range.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <qwt_plot.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_div.h>
#include <qwt_scale_widget.h>

#include <QFontMetrics>
#include <QPainter>
#include <array>

namespace tendon::gui {
namespace {

constexpr std::array kValueAxes{QwtAxis::YLeft, QwtAxis::YRight};
constexpr std::array kAxes{QwtAxis::XBottom, QwtAxis::YLeft, QwtAxis::YRight};
constexpr int kSide = 46;  // labels of a Y axis, and the empty side without one
constexpr int kTimeSteps = 6;
constexpr int kValueSteps = 7;

QwtScaleDiv Division(const AxisRange& range, double step) {
  const std::vector<double> ticks = TicksOf(range, step);
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
  plot.setAxisScaleDraw(QwtAxis::XBottom, new TimeLabels);
  for (const auto axis : kValueAxes) {
    plot.setAxisScaleDraw(axis, new AxisLabels);
    plot.axisScaleDraw(axis)->setMinimumExtent(kSide);
  }
  // What labels may stick out beyond the ends of an axis, whichever there are: else the canvas
  // would move with them.
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

double PlotAxes::timeStep(const TimeWindow& window) {
  return NiceTimeStep(window.to() - window.from(), kTimeSteps);
}

void PlotAxes::showTime(const TimeWindow& window) {
  const double step = timeStep(window);
  auto& labels = LabelsOf<TimeLabels>(plot_, QwtAxis::XBottom);
  labels.setStep(step);
  if (labels.setLive(window.isLive())) plot_.axisWidget(QwtAxis::XBottom)->update();
  plot_.setAxisScaleDiv(QwtAxis::XBottom,
                        Division({.low = window.from(), .high = window.to()}, step));
}

void PlotAxes::showValues(const std::vector<UnitAxis>& axes) {
  const Theme& theme = Theme::instance();
  // The right one keeps its place while it has nothing to say.
  plot_.axisScaleDraw(QwtAxis::YRight)
      ->enableComponent(QwtAbstractScaleDraw::Labels, axes.size() > 1);
  for (std::size_t i = 0; i < kValueAxes.size() && i < axes.size(); ++i) {
    const AxisRange& range = axes[i].range;
    const double step = NiceStep(range.span(), kValueSteps);
    auto& labels = LabelsOf<AxisLabels>(plot_, kValueAxes[i]);
    labels.setStep(step);
    plot_.setAxisScaleDiv(kValueAxes[i], Division(range, step));
    const bool colored = axes.size() > 1 && axes[i].color_index >= 0;
    const QColor color = colored ? theme.curve(axes[i].color_index) : theme.color(Token::kDim);
    if (labels.setColor(color)) plot_.axisWidget(kValueAxes[i])->update();
  }
}

void PlotAxes::paintUnits(const std::vector<UnitAxis>& axes) const {
  QPainter painter(&plot_);
  painter.setFont(Theme::instance().small());
  const QRect area = plot_.canvas()->geometry();
  for (std::size_t i = 0; i < kValueAxes.size() && i < axes.size(); ++i) {
    const bool left = i == 0;
    const QRect place = left ? QRect(2 * kGrid, 0, area.width(), kTop)
                             : QRect(area.left(), 0, area.width() + kSide - kGrid, kTop);
    painter.setPen(LabelsOf<AxisLabels>(plot_, kValueAxes[i]).color());
    painter.drawText(place, (left ? Qt::AlignLeft : Qt::AlignRight), axes[i].unit);
  }
}

}  // namespace tendon::gui
