#pragma once

#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/series/time_window.h>
#include <qwt_plot_item.h>

#include <cstdint>
#include <vector>

namespace tendon::gui {

/// Marks the times without rows by coloured bands as high as the plot. A band for lost rows shows
/// their number. Bands of another colour mark the times in which a source was restarted, did not
/// run, or sent no rows.
class GapBands final : public QwtPlotItem {
 public:
  /// Both arguments must outlive this item.
  GapBands(const CurveSet& curves, const TimeWindow& window);

  void draw(QPainter* painter, const QwtScaleMap& x_map, const QwtScaleMap& y_map,
            const QRectF& canvas_rect) const override;

 private:
  struct Band {
    double left;
    double right;
    std::uint64_t lost;  // 0 if unknown
    bool is_standstill;  // the source did not run, so no rows were lost
  };

  [[nodiscard]] std::vector<Band> bandsOf(const Curve& curve, const QwtScaleMap& x_map,
                                          const QRectF& rect) const;
  void drawLabels(QPainter& painter, const std::vector<Band>& bands, const QRectF& rect) const;

  const CurveSet& curves_;
  const TimeWindow& window_;
};

}  // namespace tendon::gui
