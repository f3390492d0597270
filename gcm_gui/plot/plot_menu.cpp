#include <gcm_gui/plot/picture/plot_picture.h>
#include <gcm_gui/plot/plot_menu.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>

#include <QActionGroup>
#include <QMenu>
#include <utility>

namespace tendon::gui {

void FillPlotMenu(QMenu& menu, PlotPanel& panel, PlotView& view) {
  QMenu& fits = *menu.addMenu("Values");
  auto* group = new QActionGroup(&fits);
  for (const auto& [fit, text] :
       {std::pair{Fit::kClose, "Fit what is seen"}, std::pair{Fit::kGrow, "Only grow"},
        std::pair{Fit::kSymmetric, "Symmetric around 0"}}) {
    QAction* action =
        group->addAction(fits.addAction(text, &view, [&view, fit = fit] { view.setFit(fit); }));
    action->setCheckable(true);
    action->setChecked(view.fit() == fit);
  }
  QAction* statistics =
      menu.addAction("Statistics", &view, [&view](bool shown) { view.setStatistics(shown); });
  statistics->setCheckable(true);
  statistics->setChecked(view.hasStatistics());
  menu.addSeparator();
  menu.addAction("Follow live data", &view, &PlotView::goLive);
  menu.addAction("Back to what was shown before", &view, &PlotView::goBack);
  menu.addSeparator();
  menu.addAction("Copy picture", &view, [&view] { CopyPicture(view); });
  menu.addAction("Save picture…", &panel, &PlotPanel::askForPicture);
  menu.addAction("Save what is seen as CSV…", &panel, &PlotPanel::askForCsv);
  menu.addSeparator();
  menu.addAction("Open layout…", &panel, &PlotPanel::askForLayout);
  menu.addAction("Save layout of all plots…", &panel, &PlotPanel::askToSaveLayout);
}

}  // namespace tendon::gui
