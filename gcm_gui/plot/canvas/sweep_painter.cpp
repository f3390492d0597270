#include <gcm_gui/plot/canvas/sweep_painter.h>

#include <gcm_gui/theme/theme.h>
#include <qwt_axis.h>
#include <qwt_plot.h>
#include <qwt_plot_dict.h>
#include <qwt_scale_map.h>

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr double kBar = 12;  // pixels

bool IsDrawnOnce(const QwtPlotItem& item) {
  return item.rtti() == QwtPlotItem::Rtti_PlotGrid || item.rtti() == kPlacesItself;
}

}  // namespace

void DrawSweep(const QwtPlot& plot, const TimeWindow& window, QPainter& painter,
               const QRectF& canvas_rect, const QwtScaleMap* maps) {
  const QwtScaleMap& present = maps[QwtAxis::XBottom];
  QwtScaleMap former = present;  // in each column, the time is one window length earlier
  const double length = window.to() - window.from();
  former.setScaleInterval(present.s1() - length, present.s2() - length);
  const double head = std::round(present.transform(window.head()));
  const double bar_end = std::min(head + kBar, canvas_rect.right() + 1);
  const QRectF left(canvas_rect.topLeft(), QPointF(head, canvas_rect.bottom()));
  const QRectF right(QPointF(bar_end, canvas_rect.top()), canvas_rect.bottomRight());
  const auto draw = [&](const QwtPlotItem& item, const QwtScaleMap& x_map, const QRectF& part) {
    if (part.width() <= 0) return;
    painter.save();
    painter.setClipRect(part, Qt::IntersectClip);
    item.draw(&painter, x_map, maps[item.yAxis()], canvas_rect);
    painter.restore();
  };
  for (const QwtPlotItem* item : plot.itemList()) {
    if (!item->isVisible()) continue;
    if (IsDrawnOnce(*item)) {
      draw(*item, present, canvas_rect);
    } else {
      draw(*item, present, left);
      draw(*item, former, right);
    }
  }
  const Theme& theme = Theme::instance();
  painter.fillRect(QRectF(QPointF(head, canvas_rect.top()), QPointF(bar_end, canvas_rect.bottom())),
                   theme.color(Token::kPanel));
  painter.fillRect(QRectF(head, canvas_rect.top(), 1, canvas_rect.height()),
                   theme.color(Token::kText, 0.7));
}

}  // namespace tendon::gui
