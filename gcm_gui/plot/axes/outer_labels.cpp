#include <gcm_gui/plot/axes/outer_labels.h>
#include <gcm_gui/plot/axes/plot_axes.h>
#include <gcm_gui/plot/canvas/axis_labels.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tendon::gui {
namespace {

constexpr int kSpacing = 8;  // from the canvas, or the column before, to the labels

}  // namespace

QColor AxisColor(const std::vector<UnitAxis>& axes, std::size_t index) {
  const Theme& theme = Theme::instance();
  const bool colored = axes.size() > 1 && axes[index].color_index >= 0;
  return colored ? theme.curve(axes[index].color_index) : theme.color(Token::kDim);
}

QString ValueText(double place, double step, ValueScale scale) {
  return scale == ValueScale::kLinear ? NumberText(place, step) : LogarithmicText(place);
}

bool OuterLabels::show(const std::vector<UnitAxis>& axes, ValueScale scale) {
  const std::size_t first = std::min(PlotAxes::kOfQwt, axes.size());
  const std::size_t count = std::min(PlotAxes::kMost, axes.size()) - first;
  bool is_new = columns_.size() != count;
  columns_.resize(count);
  const QFontMetrics metrics(Theme::instance().small());
  for (std::size_t i = 0; i < count; ++i) {
    const UnitAxis& axis = axes[first + i];
    Column& column = columns_[i];
    ValueTicks ticks = TicksOf(axis.range, scale, PlotAxes::kValueSteps);
    std::vector<QString> texts;
    for (const double place : ticks.places) texts.push_back(ValueText(place, ticks.step, scale));
    const QColor color = AxisColor(axes, first + i);
    const bool is_same_unit = column.unit == axis.unit && column.width > 0;
    if (is_same_unit && column.range == axis.range && column.texts == texts &&
        column.color == color) {
      continue;
    }
    is_new = true;
    const int least = is_same_unit ? column.width : PlotAxes::kSide;
    column = {.unit = axis.unit, .range = axis.range, .ticks = std::move(ticks), .color = color};
    column.width = std::max(least, kSpacing + metrics.horizontalAdvance(axis.unit));
    for (const QString& text : texts) {
      column.width = std::max(column.width, kSpacing + metrics.horizontalAdvance(text));
    }
    column.texts = std::move(texts);
  }
  return is_new;
}

int OuterLabels::width() const {
  int width = 0;
  for (const Column& column : columns_) width += column.width;
  return width;
}

void OuterLabels::paint(QPainter& painter, const QRect& rows) const {
  const QFontMetrics metrics(painter.font());
  int left = rows.left();
  for (const Column& column : columns_) {
    painter.setPen(column.color);
    for (std::size_t i = 0; i < column.texts.size(); ++i) {
      const double part = (column.ticks.places[i] - column.range.low) / column.range.span();
      const int y = rows.bottom() - static_cast<int>(std::lround(part * (rows.height() - 1)));
      const QRect place(left + kSpacing, y - metrics.height() / 2, column.width, metrics.height());
      painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, column.texts[i]);
    }
    left += column.width;
  }
}

void OuterLabels::paintUnits(QPainter& painter, int left, int height) const {
  for (const Column& column : columns_) {
    painter.setPen(column.color);
    painter.drawText(QRect(left + kSpacing, 0, column.width, height), Qt::AlignLeft, column.unit);
    left += column.width;
  }
}

}  // namespace tendon::gui
