#include <gcm_gui/plot/plot_tabs.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/plot_page.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/series/signal_path.h>

#include <QStackedWidget>
#include <QStringList>
#include <QTabBar>
#include <algorithm>

namespace tendon::gui {
namespace {

/// Returns the column of a signal: `Joints`. If another of the signals has a column of this name in
/// another component, also returns the component: `arm.Joints`.
QString TabTitle(const QString& path, const QStringList& signals_of_all_tabs) {
  const auto whole = [](const QString& signal) {
    return ShortName(SourceOf(signal) + '.' + ColumnOf(signal));
  };
  const QString column = ColumnOf(path);
  const bool is_ambiguous = std::any_of(
      signals_of_all_tabs.begin(), signals_of_all_tabs.end(), [&](const QString& other) {
        return ColumnOf(other) == column && whole(other) != whole(path);
      });
  return is_ambiguous ? whole(path) : column;
}

}  // namespace

PlotTabs::PlotTabs(QTabBar& bar, QStackedWidget& pages) : bar_(bar), pages_(pages) {}

PlotPage& PlotTabs::page(int index) const { return static_cast<PlotPage&>(*pages_.widget(index)); }

PlotPage& PlotTabs::pageOf(const PlotView& view) const {
  int index = 0;
  while (!page(index).holds(view)) ++index;
  return page(index);
}

PlotPage& PlotTabs::currentPage() const { return page(pages_.currentIndex()); }

std::vector<PlotView*> PlotTabs::plots() const {
  std::vector<PlotView*> plots;
  for (int i = 0; i < pages_.count(); ++i) {
    const auto& views = page(i).views();
    plots.insert(plots.end(), views.begin(), views.end());
  }
  return plots;
}

void PlotTabs::setName(const PlotView& view, const QString& name) {
  PlotPage& page = pageOf(view);
  page.setName(name.simplified());
  update(page);
}

const QString& PlotTabs::name(const PlotView& view) const { return pageOf(view).name(); }

QString PlotTabs::title() const { return bar_.tabText(pages_.currentIndex()); }

// All plots of a page except the first also get a number.
void PlotTabs::update(const PlotPage& page) {
  const auto& views = page.views();
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto& curves = views[i]->curves().curves();
    const QString name = curves.empty() ? QString::number(pages_.indexOf(&page) + 1)
                                        : ColumnOf(curves.front()->path());
    const QString number = i == 0 ? QString() : ' ' + QString::number(i + 1);
    views[i]->setAccessibleName(Words::tr("Plot ") + name + number);
    views[i]->canvas()->setAccessibleName(views[i]->accessibleName());
    ExceptionGuard::setName(*views[i], {});
  }
  update();
}

// The title of a tab is the name given by the user; otherwise the TabTitle() of its first curve;
// for an empty page, a number. A title that an earlier tab has also gets a number.
void PlotTabs::update() {
  QStringList firsts;
  for (int i = 0; i < pages_.count(); ++i) {
    QString first;
    for (const PlotView* view : page(i).views()) {
      if (first.isEmpty() && !view->curves().empty())
        first = view->curves().curves().front()->path();
    }
    firsts << first;
  }
  QStringList titles;
  for (int i = 0; i < pages_.count(); ++i) {
    const QString title =
        firsts[i].isEmpty() ? Words::tr("Plot %1").arg(i + 1) : TabTitle(firsts[i], firsts);
    const auto same = titles.count(title);
    titles << title;
    const QString number = same == 0 ? QString() : ' ' + QString::number(same + 1);
    bar_.setTabText(i, page(i).name().isEmpty() ? title + number : page(i).name());
  }
}

}  // namespace tendon::gui
