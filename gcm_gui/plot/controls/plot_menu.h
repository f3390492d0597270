#pragma once

class QMenu;

namespace tendon::gui {

class PlotPanel;
class PlotView;

/// Fills `menu` with the actions of one plot: value range, statistics, picture, and the layout of
/// all plots. `panel` and `view` must outlive the menu.
void FillPlotMenu(QMenu& menu, PlotPanel& panel, PlotView& view);

}  // namespace tendon::gui
