#pragma once

#include <gcm_gui/plot/series/time_window.h>
#include <qwt_plot_item.h>

#include <QRectF>

class QPainter;
class QwtPlot;
class QwtScaleMap;

namespace tendon::gui {

/// For QwtPlotItem::rtti() of items that know by themselves where a sweeping window shows a time.
inline constexpr int kPlacesItself = QwtPlotItem::Rtti_PlotUserItem + 1;

/// Draws the items of `plot` as a sweeping `window` shows them: what has come since left of the
/// head, what was there a length ago right of it, and an empty bar between. `maps` are those of
/// QwtPlot::drawItems().
void DrawSweep(const QwtPlot& plot, const TimeWindow& window, QPainter& painter,
               const QRectF& canvas_rect, const QwtScaleMap* maps);

}  // namespace tendon::gui
