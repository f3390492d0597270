#pragma once

#include <gcm_gui/plot/series/mark_track.h>
#include <gcm_gui/plot/series/time_window.h>
#include <qwt_plot_item.h>

#include <QString>
#include <cstdint>
#include <vector>

namespace tendon::gui {

/// Draws marks at the foot of a plot: a line at the time, a symbol for the kind, and a label.
/// Overlapping labels become one with their number.
class MarkFlags final : public QwtPlotItem {
 public:
  /// One or several marks that are drawn as one.
  struct Flag {
    double x = 0;  ///< on the canvas
    std::vector<const Mark*> marks;
    QString label;
    double end = 0;  ///< of the label
  };

  /// Both arguments must outlive this item.
  MarkFlags(const MarkTrack& track, const TimeWindow& window);

  /// From left to right.
  [[nodiscard]] std::vector<Flag> flags(const QwtScaleMap& x_map, const QRectF& canvas_rect) const;
  /// The texts of all marks of the flag at `x`, one per line; empty if there is none.
  [[nodiscard]] QString textAt(double x, const QwtScaleMap& x_map, const QRectF& canvas_rect) const;

  /// The texts of the newest marks in [from_ns, to_ns], one per line.
  [[nodiscard]] QString textBetween(std::int64_t from_ns, std::int64_t to_ns) const;

  void draw(QPainter* painter, const QwtScaleMap& x_map, const QwtScaleMap& y_map,
            const QRectF& canvas_rect) const override;

 private:
  const MarkTrack& track_;
  const TimeWindow& window_;
};

}  // namespace tendon::gui
