#pragma once

#include <gcm_gui/plot/canvas/span_raster.h>
#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/series/time_window.h>
#include <qwt_plot_item.h>

namespace tendon::gui {

/// Draws all curves of a plot as one item: the part within `window`, each on the axis of its unit.
class CurveLayer final : public QwtPlotItem {
 public:
  /// Both arguments must outlive this item.
  CurveLayer(const CurveSet& curves, const TimeWindow& window);

  /// Returns the time slices for drawing on a canvas of size `rect` at `device_pixel_ratio`.
  [[nodiscard]] TimeSlices slicesOf(const QwtScaleMap& x_map, const QRectF& rect,
                                    double device_pixel_ratio) const;

  void draw(QPainter* painter, const QwtScaleMap& x_map, const QwtScaleMap& y_map,
            const QRectF& canvas_rect) const override;

 private:
  void drawLines(QPainter& painter, const Curve& curve, const Envelope& envelope,
                 const QwtScaleMap& map, const AxisFrame& frame, const QRectF& rect) const;
  [[nodiscard]] static double DotRadius(double distance);
  void drawDots(QPainter& painter, const Curve& curve, const QwtScaleMap& x_map,
                const QwtScaleMap& y_map, const QRectF& rect) const;

  /// Returns the pixel row of a value at this `distance` from the base. A value without a position
  /// on the axis is in the lowest row; a value far outside is just outside the canvas.
  [[nodiscard]] double rowOf(double distance, const AxisFrame& frame, const QwtScaleMap& map,
                             const QRectF& rect) const;

  const CurveSet& curves_;
  const TimeWindow& window_;
  mutable SpanRaster raster_;
};

}  // namespace tendon::gui
