#pragma once

class QMenu;

namespace tendon::gui {

class PlotPanel;
class PlotView;

/// What can be done with one plot: how its values are fitted, its statistics, its picture, and the
/// layout of all. `menu` is filled; both must outlive it.
void FillPlotMenu(QMenu& menu, PlotPanel& panel, PlotView& view);

}  // namespace tendon::gui
