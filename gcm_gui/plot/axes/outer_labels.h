#pragma once

#include <gcm_gui/plot/axes/value_ticks.h>
#include <gcm_gui/plot/series/curve_set.h>

#include <QColor>
#include <QRect>
#include <QString>
#include <vector>

class QPainter;

namespace tendon::gui {

/// The labels of the axes for which QwtPlot has no place: columns side by side, from the right edge
/// of its own axis outwards, each in the colour of its curve. GUI thread.
class OuterLabels {
 public:
  /// Returns whether anything is to be painted anew.
  bool show(const std::vector<UnitAxis>& axes, ValueScale scale);
  /// Of all columns, in pixels. Only grows while the units stay.
  [[nodiscard]] int width() const;
  /// `rows` is the height of the canvas, and where the first column begins.
  void paint(QPainter& painter, const QRect& rows) const;
  /// Above the columns, as the units of the others are.
  void paintUnits(QPainter& painter, int left, int height) const;

 private:
  struct Column {
    QString unit;
    QString head;  // the unit and the base
    AxisRange range;
    ValueTicks ticks;
    QColor color;
    int width = 0;
  };

  std::vector<Column> columns_;
};

/// In the colour of its curve, where a plot has several axes and this one has one curve; dim else.
[[nodiscard]] QColor AxisColor(const std::vector<UnitAxis>& axes, std::size_t index);

}  // namespace tendon::gui
