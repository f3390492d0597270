#include <gcm_gui/fence/fence.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/link/plot_page.h>
#include <gcm_gui/plot/plot_head.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>

#include <QInputDialog>
#include <QMenu>
#include <QStackedWidget>
#include <QTabBar>
#include <algorithm>
#include <memory>
#include <utility>

namespace tendon::gui {

PlotView& PlotPanel::addPlot() {
  auto* page = new PlotPage(pages_);
  connect(page, &PlotPage::currentChanged, this, &PlotPanel::updateHead);
  connect(page, &PlotPage::closeRequested, this, [this](PlotView* view) { closePlot(*view); });
  pages_->addWidget(page);
  const int index = head_->tabs().addTab({});
  PlotView& view = page->current();
  prepare(view);
  nameTab(view);
  showPage(index);
  return view;
}

PlotView& PlotPanel::splitPlot() {
  PlotView& view = page(pages_->currentIndex()).split();
  prepare(view);
  nameTab(view);
  updateHead();
  return view;
}

void PlotPanel::closePlot(int index) { closePlot(plot(index)); }

void PlotPanel::closePlot(PlotView& view) {
  QStringList paths;
  for (const auto& curve : view.curves().curves()) paths << curve->path();
  for (const QString& path : paths) removeFrom(view, path);
  PlotPage& page = pageOf(view);
  if (page.views().size() > 1) {
    page.close(view);
    return nameTab(page.current());
  }
  if (pages_->count() == 1) return;
  head_->tabs().removeTab(pages_->indexOf(&page));
  pages_->removeWidget(&page);
  page.deleteLater();
  showPage(head_->tabs().currentIndex());
}

void PlotPanel::closePage(int index) {
  const std::vector<PlotView*> views = page(index).views();
  for (PlotView* view : views) closePlot(*view);
}

void PlotPanel::showTabMenu(const QPoint& position) {
  const int index = head_->tabs().tabAt(position);
  if (index < 0) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const bool are_several = page(index).views().size() > 1;
  menu->addAction(Words::tr("Rename…"), this, [this, index] {
    showPage(index);
    askForName();
  });
  menu->addAction(are_several ? Words::tr("Close plots") : Words::tr("Close plot"), this,
                  [this, index] { closePage(index); });
  menu->popup(head_->tabs().mapToGlobal(position));
}

void PlotPanel::showPage(int index) {
  head_->tabs().setCurrentIndex(index);
  pages_->setCurrentIndex(index);
  updateHead();
}

void PlotPanel::showPlot(int index) {
  PlotView& view = plot(index);
  PlotPage& page = pageOf(view);
  page.setCurrent(view);
  showPage(pages_->indexOf(&page));
}

void PlotPanel::askForName() {
  PlotView& view = currentPlot();
  auto* dialog = new QInputDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(Words::tr("Rename this plot"));
  dialog->setLabelText(Words::tr("Name; leave it empty for the default name"));
  dialog->setTextValue(pageOf(view).name());
  connect(dialog, &QInputDialog::textValueSelected, &view,
          [this, &view](const QString& name) { setName(view, name); });
  dialog->open();
}

void PlotPanel::setName(PlotView& view, const QString& name) {
  pageOf(view).setName(name.simplified());
  nameTab(view);
}

QString PlotPanel::name(int index) const { return pageOf(plot(index)).name(); }

// Sets the title of a tab: the given name, otherwise the column of the first curve, or a number
// while the page is empty.
void PlotPanel::nameTab(PlotView& view) {
  const PlotPage& page = pageOf(view);
  const int index = pages_->indexOf(&page);
  const auto name_of = [&](const PlotView& each) {
    const auto& curves = each.curves().curves();
    return curves.empty() ? Words::tr("Plot %1").arg(index + 1) : ColumnOf(curves.front()->path());
  };
  const auto& views = page.views();
  for (std::size_t i = 0; i < views.size(); ++i) {  // the plots below the first also have a number
    const QString number = i == 0 ? QString() : ' ' + QString::number(i + 1);
    views[i]->setAccessibleName(Words::tr("Plot ") + name_of(*views[i]) + number);
    views[i]->canvas()->setAccessibleName(views[i]->accessibleName());
    Fence::setName(*views[i], {});
  }
  const auto named = std::find_if(views.begin(), views.end(),
                                  [](const PlotView* each) { return !each->curves().empty(); });
  const QString shown = name_of(named == views.end() ? view : **named);
  head_->tabs().setTabText(index, page.name().isEmpty() ? shown : page.name());
}

PlotPage& PlotPanel::page(int index) const {
  return static_cast<PlotPage&>(*pages_->widget(index));
}

PlotPage& PlotPanel::pageOf(const PlotView& view) const {
  int index = 0;
  while (!page(index).holds(view)) ++index;
  return page(index);
}

std::vector<PlotView*> PlotPanel::plots() const {
  std::vector<PlotView*> plots;
  for (int i = 0; i < pages_->count(); ++i) {
    const auto& views = page(i).views();
    plots.insert(plots.end(), views.begin(), views.end());
  }
  return plots;
}

PlotView& PlotPanel::plot(int index) const { return *plots().at(static_cast<std::size_t>(index)); }

bool PlotPanel::isBelow(int index) const {
  const PlotView& view = plot(index);
  return pageOf(view).views().front() != &view;
}

int PlotPanel::plotCount() const { return static_cast<int>(plots().size()); }

PlotView& PlotPanel::currentPlot() const { return page(pages_->currentIndex()).current(); }

int PlotPanel::currentIndex() const {
  const std::vector<PlotView*> all = plots();
  return static_cast<int>(std::find(all.begin(), all.end(), &currentPlot()) - all.begin());
}

// Moves a curve with its samples; if the path is already there, only removes it.
void PlotPanel::move(const QString& path, quint64 from, PlotView& to) {
  for (PlotView* view : plots()) {
    if (view->id() != from || view == &to) continue;
    std::unique_ptr<Curve> curve = view->takeCurve(path);
    if (curve == nullptr) return;
    if (to.curve(path) == nullptr) to.adoptCurve(std::move(curve));
    shareMemory();
    nameTab(*view);
    nameTab(to);
    pageOf(to).setCurrent(to);
    updateHead();
  }
}

}  // namespace tendon::gui
