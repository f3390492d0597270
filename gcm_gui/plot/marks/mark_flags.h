#pragma once

#include <gcm_gui/plot/marks/mark_track.h>
#include <gcm_gui/plot/series/time_window.h>
#include <qwt_plot_item.h>

#include <QString>
#include <cstdint>
#include <vector>

namespace tendon::gui {

/// Marks at the foot of a plot: a stroke at the moment, a sign for what kind it is, and its label.
/// Where labels would overlap, one says how many there are.
class MarkFlags final : public QwtPlotItem {
 public:
  /// What is drawn as one.
  struct Flag {
    double x = 0;  ///< on the canvas
    std::vector<const Mark*> marks;
    QString label;
    double end = 0;  ///< of the label
  };

  /// Both must outlive this item.
  MarkFlags(const MarkTrack& track, const TimeWindow& window);

  /// From left to right.
  [[nodiscard]] std::vector<Flag> flags(const QwtScaleMap& x_map, const QRectF& canvas_rect) const;
  /// All of those of the flag at `x`, a line each; empty where there is none.
  [[nodiscard]] QString textAt(double x, const QwtScaleMap& x_map, const QRectF& canvas_rect) const;

  /// The newest of those in [from_ns, to_ns], a line each.
  [[nodiscard]] QString textBetween(std::int64_t from_ns, std::int64_t to_ns) const;

  void draw(QPainter* painter, const QwtScaleMap& x_map, const QwtScaleMap& y_map,
            const QRectF& canvas_rect) const override;

 private:
  const MarkTrack& track_;
  const TimeWindow& window_;
};

}  // namespace tendon::gui
