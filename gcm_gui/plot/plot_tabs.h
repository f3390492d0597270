#pragma once

#include <QString>
#include <vector>

class QStackedWidget;
class QTabBar;

namespace tendon::gui {

class PlotPage;
class PlotView;

/// The pages of plots, each with a tab. Finds the page of a plot, and names the tabs and the plots.
/// GUI thread.
class PlotTabs {
 public:
  /// `bar` has a tab for each widget of `pages`, which are of class PlotPage. Both must outlive
  /// this object.
  PlotTabs(QTabBar& bar, QStackedWidget& pages);

  [[nodiscard]] PlotPage& page(int index) const;
  [[nodiscard]] PlotPage& pageOf(const PlotView& view) const;
  [[nodiscard]] PlotPage& currentPage() const;
  /// The plots of all pages, from the top of the first page.
  [[nodiscard]] std::vector<PlotView*> plots() const;

  /// Sets the name of the plot's page. With an empty name, the tab shows the contents of the page.
  void setName(const PlotView& view, const QString& name);
  [[nodiscard]] const QString& name(const PlotView& view) const;
  /// The title of the current tab.
  [[nodiscard]] QString title() const;
  /// Names the plots of a page, and all tabs. Must be called after the curves or plots of the page
  /// have changed.
  void update(const PlotPage& page);
  /// Sets the titles of all tabs. Must be called after a page was removed.
  void update();

 private:
  QTabBar& bar_;
  QStackedWidget& pages_;
};

}  // namespace tendon::gui
