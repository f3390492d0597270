#pragma once

#include <gcm_gui/plot/canvas/value_ticks.h>
#include <gcm_gui/plot/series/curve_set.h>

#include <QColor>
#include <QRect>
#include <QString>
#include <cstddef>
#include <vector>

class QPainter;

namespace tendon::gui {

/// The labels of the axes that QwtPlot cannot have. They are columns side by side to the right of
/// QwtPlot's own axis, each in the colour of its curve. GUI thread.
class OuterLabels {
 public:
  /// Returns true if a repaint is needed.
  bool show(const std::vector<UnitAxis>& axes, ValueScale scale);
  /// The width of all columns in pixels. Never shrinks while the units are the same.
  [[nodiscard]] int width() const;
  /// Paints the columns. `rows` is the height of the canvas and the left edge of the first column.
  void paint(QPainter& painter, const QRect& rows) const;
  /// Paints the units above the columns, as above the other axes.
  void paintUnits(QPainter& painter, int left, int height) const;

 private:
  struct Column {
    QString unit;
    QString head;  // unit and base of the labels
    AxisRange range;
    ValueTicks ticks;
    QColor color;
    int width = 0;
  };

  std::vector<Column> columns_;
};

/// Returns the colour of an axis: if the plot has several axes and only one curve uses this axis,
/// the colour of that curve; otherwise the dim colour.
[[nodiscard]] QColor AxisColor(const std::vector<UnitAxis>& axes, std::size_t index);

}  // namespace tendon::gui
