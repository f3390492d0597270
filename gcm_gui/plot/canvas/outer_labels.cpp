#include <gcm_gui/plot/canvas/outer_labels.h>

#include <gcm_gui/plot/canvas/plot_axes.h>
#include <gcm_gui/theme/theme.h>

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tendon::gui {
namespace {

constexpr int kSpacing = 8;  // pixels between the labels and the canvas, or the column before

}  // namespace

QColor AxisColor(const std::vector<UnitAxis>& axes, std::size_t index) {
  const Theme& theme = Theme::instance();
  const bool colored = axes.size() > 1 && axes[index].color_index >= 0;
  return colored ? theme.curve(axes[index].color_index) : theme.color(Token::kDim);
}

bool OuterLabels::show(const std::vector<UnitAxis>& axes, ValueScale scale) {
  const std::size_t first = std::min(PlotAxes::kOfQwt, axes.size());
  const std::size_t count = std::min(PlotAxes::kMax, axes.size()) - first;
  bool is_new = columns_.size() != count;
  columns_.resize(count);
  const QFontMetrics metrics(Theme::instance().small());
  for (std::size_t i = 0; i < count; ++i) {
    const UnitAxis& axis = axes[first + i];
    Column& column = columns_[i];
    ValueTicks ticks = TicksOf(axis, scale, PlotAxes::kValueSteps);
    const QString head = HeadOf(axis);
    const QColor color = AxisColor(axes, first + i);
    const bool is_same_unit = column.unit == axis.unit && column.width > 0;
    if (is_same_unit && column.head == head && column.range == axis.range &&
        column.ticks == ticks && column.color == color) {
      continue;
    }
    is_new = true;
    const int least = is_same_unit ? column.width : PlotAxes::kSide;
    column = {.unit = axis.unit,
              .head = head,
              .range = axis.range,
              .ticks = std::move(ticks),
              .color = color};
    column.width = std::max(least, kSpacing + metrics.horizontalAdvance(head));
    for (const QString& text : column.ticks.texts) {
      column.width = std::max(column.width, kSpacing + metrics.horizontalAdvance(text));
    }
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
    for (std::size_t i = 0; i < column.ticks.texts.size(); ++i) {
      const double part = (column.ticks.places[i] - column.range.low) / column.range.span();
      const int y = rows.bottom() - static_cast<int>(std::lround(part * (rows.height() - 1)));
      const QRect place(left + kSpacing, y - metrics.height() / 2, column.width, metrics.height());
      painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, column.ticks.texts[i]);
    }
    left += column.width;
  }
}

void OuterLabels::paintUnits(QPainter& painter, int left, int height) const {
  for (const Column& column : columns_) {
    painter.setPen(column.color);
    painter.drawText(QRect(left + kSpacing, 0, column.width, height), Qt::AlignLeft, column.head);
    left += column.width;
  }
}

}  // namespace tendon::gui
