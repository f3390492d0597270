#pragma once

#include <gcm_gui/plot/series/time_window.h>
#include <qwt_plot_item.h>

#include <QRectF>

class QPainter;
class QwtPlot;
class QwtScaleMap;

namespace tendon::gui {

/// The QwtPlotItem::rtti() of items that draw themselves correctly in a sweeping window.
inline constexpr int kPlacesItself = QwtPlotItem::Rtti_PlotUserItem + 1;

/// Draws the items of `plot` for a sweeping `window`: the present sweep to the left of the head,
/// the previous sweep to the right, and an empty bar between them. `maps` are the maps given to
/// QwtPlot::drawItems().
void DrawSweep(const QwtPlot& plot, const TimeWindow& window, QPainter& painter,
               const QRectF& canvas_rect, const QwtScaleMap* maps);

}  // namespace tendon::gui
