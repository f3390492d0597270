#pragma once

#include <gcm_gui/plot/canvas/value_ticks.h>
#include <gcm_gui/plot/series/curve_set.h>

#include <QColor>
#include <QRect>
#include <QString>
#include <vector>

class QPainter;

namespace tendon::gui {

/// The labels of the axes for which QwtPlot has no place: columns side by side to the right of its
/// own axis, each in the colour of its curve. GUI thread.
class OuterLabels {
 public:
  /// Returns true if a repaint is needed.
  bool show(const std::vector<UnitAxis>& axes, ValueScale scale);
  /// The width of all columns in pixels. Never shrinks while the units are the same.
  [[nodiscard]] int width() const;
  /// `rows` gives the height of the canvas and the left edge of the first column.
  void paint(QPainter& painter, const QRect& rows) const;
  /// Paints the units above the columns, like those of the other axes.
  void paintUnits(QPainter& painter, int left, int height) const;

 private:
  struct Column {
    QString unit;
    QString head;  // the unit and the base of the labels
    AxisRange range;
    ValueTicks ticks;
    QColor color;
    int width = 0;
  };

  std::vector<Column> columns_;
};

/// The colour of the only curve of an axis if the plot has several axes; otherwise dim.
[[nodiscard]] QColor AxisColor(const std::vector<UnitAxis>& axes, std::size_t index);

}  // namespace tendon::gui
