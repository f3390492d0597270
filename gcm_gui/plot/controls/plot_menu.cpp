#include <gcm_gui/plot/controls/plot_menu.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/plot_files.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_picture.h>
#include <gcm_gui/plot/plot_view.h>

#include <QActionGroup>
#include <QFileInfo>
#include <QMenu>
#include <utility>

namespace tendon::gui {
namespace {

void AddRecording(QMenu& menu, PlotPanel& panel, PlotView& view, const QString& recording) {
  QMenu& one = *menu.addMenu(QFileInfo(recording).fileName());
  one.addAction(Words::tr("Shift…"), &view,
                [&view, recording] { view.recordedCurves().askForShift(recording); })
      ->setShortcut(Qt::Key_T);
  one.addAction(Words::tr("Begin at the left edge"), &panel,
                [&panel, &view, recording] { panel.showBegin(view, recording); });
  one.addAction(Words::tr("Remove its curves"), &view, [&view, recording] {
    QStringList paths;
    for (const auto& curve : view.curves().curves()) {
      if (curve->recording() == recording) paths << curve->path();
    }
    for (const QString& path : paths) Q_EMIT view.curveRemovalRequested(path);
  });
}

}  // namespace

void FillPlotMenu(QMenu& menu, PlotPanel& panel, PlotView& view) {
  QMenu& fits = *menu.addMenu(Words::tr("Values"));
  auto* group = new QActionGroup(&fits);
  for (const auto& [fit, text] : {std::pair{Fit::kClose, Words::tr("Fit the visible part")},
                                  std::pair{Fit::kGrow, Words::tr("Only grow")},
                                  std::pair{Fit::kSymmetric, Words::tr("Symmetric around 0")}}) {
    QAction* action =
        group->addAction(fits.addAction(text, &view, [&view, fit = fit] { view.setFit(fit); }));
    action->setCheckable(true);
    action->setChecked(view.curves().fit() == fit);
    action->setEnabled(fit != Fit::kSymmetric || view.curves().scale() == ValueScale::kLinear);
  }
  fits.addSeparator();
  QAction* logarithmic = fits.addAction(Words::tr("Logarithmic"), &view, [&view](bool chosen) {
    view.setScale(chosen ? ValueScale::kLogarithmic : ValueScale::kLinear);
  });
  logarithmic->setShortcut(Qt::Key_L);
  logarithmic->setCheckable(true);
  logarithmic->setChecked(view.curves().scale() == ValueScale::kLogarithmic);
  QAction* statistics = menu.addAction(Words::tr("Statistics"), &view,
                                       [&view](bool shown) { view.setStatistics(shown); });
  statistics->setCheckable(true);
  statistics->setChecked(view.hasStatistics());
  QAction* marks = menu.addAction(Words::tr("Marks"), &panel,
                                  [&panel](bool shown) { panel.setMarksShown(shown); });
  marks->setShortcut(Qt::Key_E);
  marks->setCheckable(true);
  marks->setChecked(panel.areMarksShown());
  menu.addSeparator();
  using Motion = TimeWindow::Motion;
  QAction* sweep = menu.addAction(Words::tr("Sweep"), &view, [&view](bool chosen) {
    view.setMotion(chosen ? Motion::kSweep : Motion::kScroll);
  });
  sweep->setShortcut(Qt::Key_S);
  sweep->setCheckable(true);
  sweep->setChecked(view.timeWindow().motion() == Motion::kSweep);
  menu.addAction(Words::tr("Follow live data"), &view.gestures(), &PlotGestures::goLive);
  menu.addAction(Words::tr("Back to the previous view"), &view.gestures(), &PlotGestures::goBack)
      ->setEnabled(view.gestures().hasFormerView());
  menu.addAction(Words::tr("Forward again"), &view.gestures(), &PlotGestures::goForward)
      ->setEnabled(view.gestures().hasLaterView());
  menu.addSeparator();
  menu.addAction(Words::tr("Add a curve of a recording…"), &panel, &PlotPanel::recordingRequested);
  for (const QString& recording : view.recordedCurves().recordings())
    AddRecording(menu, panel, view, recording);
  menu.addSeparator();
  menu.addAction(Words::tr("A plot below"), &panel, [&panel] { panel.splitPlot(); });
  menu.addAction(Words::tr("Close this plot"), &panel, [&panel, &view] { panel.closePlot(view); });
  menu.addSeparator();
  menu.addAction(Words::tr("Copy picture"), &view, [&view] { CopyPicture(view); });
  menu.addAction(Words::tr("Save picture…"), &panel.files(), &PlotFiles::askForPicture);
  menu.addAction(Words::tr("Save the visible samples as CSV…"), &panel.files(),
                 &PlotFiles::askForCsv);
  menu.addSeparator();
  menu.addAction(Words::tr("Open layout…"), &panel.files(), &PlotFiles::askForLayout);
  menu.addAction(Words::tr("Save layout of all plots…"), &panel.files(),
                 &PlotFiles::askToSaveLayout);
}

}  // namespace tendon::gui
