#pragma once

#include <gcm_gui/plot/series/mark_track.h>
#include <gcm_gui/plot/series/time_window.h>
#include <qwt_plot_item.h>

#include <QString>
#include <cstdint>
#include <vector>

namespace tendon::gui {

/// Draws marks at the bottom of a plot: a vertical line at the time of the mark, a symbol for its
/// kind, and a label. Marks whose labels would overlap become one flag; its label shows the number
/// of further marks.
class MarkFlags final : public QwtPlotItem {
 public:
  /// One or several marks that are drawn as one.
  struct Flag {
    double x = 0;  ///< position on the canvas
    std::vector<const Mark*> marks;
    QString label;
    double end = 0;  ///< right end of the label
  };

  /// Both arguments must outlive this item.
  MarkFlags(const MarkTrack& track, const TimeWindow& window);

  /// Returns the flags from left to right.
  [[nodiscard]] std::vector<Flag> flags(const QwtScaleMap& x_map, const QRectF& canvas_rect) const;
  /// Returns the texts of all marks of the flag at `x`, one per line; empty if there is no flag.
  [[nodiscard]] QString textAt(double x, const QwtScaleMap& x_map, const QRectF& canvas_rect) const;

  /// Returns the texts of the newest marks within [from_ns, to_ns], one per line.
  [[nodiscard]] QString textBetween(std::int64_t from_ns, std::int64_t to_ns) const;

  void draw(QPainter* painter, const QwtScaleMap& x_map, const QwtScaleMap& y_map,
            const QRectF& canvas_rect) const override;

 private:
  const MarkTrack& track_;
  const TimeWindow& window_;
};

}  // namespace tendon::gui
