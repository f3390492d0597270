#pragma once

#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/plot/shared_time_axis.h>

#include <QWidget>
#include <memory>
#include <vector>

class QSplitter;

namespace tendon::gui {

class PlotView;

/// Plots below each other with a common time: a change of time applies to all of them, and their
/// canvases are aligned. The current plot is the last that was clicked or had the focus. The first
/// plot with curves has the button that makes all plots live again. GUI thread.
class PlotPage : public QWidget {
  Q_OBJECT

 public:
  /// Starts with one plot.
  explicit PlotPage(QWidget* parent = nullptr);

  /// Adds an empty plot below the current one and makes it current.
  PlotView& split();
  /// Deletes `view` later. It must not be the last one.
  void close(PlotView& view);
  [[nodiscard]] const std::vector<PlotView*>& views() const { return views_; }
  [[nodiscard]] bool holds(const PlotView& view) const;
  [[nodiscard]] PlotView& current() const { return *current_; }
  void setCurrent(PlotView& view);
  /// The name given by the user; empty while the name follows the content.
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
