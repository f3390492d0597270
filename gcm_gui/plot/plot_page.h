#pragma once

#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/plot/shared_time_axis.h>

#include <QWidget>
#include <memory>
#include <vector>

class QSplitter;

namespace tendon::gui {

class PlotView;

/// Several plots below each other with a common time: a change of the time applies to all of them,
/// and their canvases are aligned. The current plot is the one that was clicked or had the focus
/// last. The button that makes all plots live again is in the first plot that has curves. GUI
/// thread.
class PlotPage : public QWidget {
  Q_OBJECT

 public:
  /// Creates a page with one plot.
  explicit PlotPage(QWidget* parent = nullptr);

  /// Adds an empty plot below the current one and makes it current.
  PlotView& split();
  /// Removes `view` from the page and deletes it later. It must not be the only plot.
  void close(PlotView& view);
  [[nodiscard]] const std::vector<PlotView*>& views() const { return views_; }
  [[nodiscard]] bool holds(const PlotView& view) const;
  [[nodiscard]] PlotView& current() const { return *current_; }
  void setCurrent(PlotView& view);
  /// The name given by the user. Empty if the user has given none; the tab then shows the contents.
  [[nodiscard]] const QString& name() const { return name_; }
  void setName(const QString& name) { name_ = name; }

  bool eventFilter(QObject* watched, QEvent* event) override;

 Q_SIGNALS:
  void currentChanged();
  void closeRequested(PlotView* view);

 private:
  PlotView& insert(int place);
  void updatePlotsAbove();
  void markCurrent();
  void align();

  std::shared_ptr<SharedTimeAxis> time_axis_;
  QSplitter* rows_;
  std::vector<PlotView*> views_;  // from the top
  PlotView* current_ = nullptr;
  QString name_;
};

}  // namespace tendon::gui
