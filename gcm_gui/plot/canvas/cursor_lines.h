#pragma once

#include <gcm_gui/plot/canvas/sweep_painter.h>
#include <gcm_gui/plot/series/cursors.h>
#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/series/time_window.h>
#include <qwt_plot_item.h>

#include <QColor>
#include <QString>
#include <vector>

namespace tendon::gui {

/// Draws the cursors A and B. Beside B, it shows the difference between the two cursors in time and
/// in the value of each curve.
class CursorLines final : public QwtPlotItem {
 public:
  /// All arguments must outlive this item.
  CursorLines(const CurveSet& curves, const TimeWindow& window, const Cursors& cursors);

  [[nodiscard]] int rtti() const override { return kPlacesItself; }
  void draw(QPainter* painter, const QwtScaleMap& x_map, const QwtScaleMap& y_map,
            const QRectF& canvas_rect) const override;

  struct Line {
    QString text;
    QColor color;
  };
  /// Returns the texts beside B; empty unless both cursors exist.
  [[nodiscard]] std::vector<Line> lines() const;

 private:
  void drawBox(QPainter& painter, double x, const QRectF& canvas_rect) const;

  const CurveSet& curves_;
  const TimeWindow& window_;
  const Cursors& cursors_;
};

/// Formats a time difference: "Δt 12.700 s · 0.0787 Hz".
[[nodiscard]] QString SpanText(double seconds);

}  // namespace tendon::gui
