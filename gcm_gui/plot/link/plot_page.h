#pragma once

#include <gcm_gui/plot/link/time_link.h>
#include <gcm_gui/plot/series/signal_path.h>

#include <QWidget>
#include <memory>
#include <vector>

class QSplitter;

namespace tendon::gui {

class PlotView;

/// Plots below each other, which show the same time: what is done to the time of one is done to
/// all, and their canvases begin and end at the same columns. One of them is the current one: the
/// last that was clicked or had the focus. The first that shows anything has the button that makes
/// them all live again. GUI thread.
class PlotPage : public QWidget {
  Q_OBJECT

 public:
  /// With one plot.
  explicit PlotPage(QWidget* parent = nullptr);

  /// An empty plot below the current one; it becomes the current one.
  PlotView& split();
  /// `view` is deleted later. Not the last one.
  void close(PlotView& view);
  [[nodiscard]] const std::vector<PlotView*>& views() const { return views_; }
  [[nodiscard]] bool holds(const PlotView& view) const;
  [[nodiscard]] PlotView& current() const { return *current_; }
  void setCurrent(PlotView& view);
  /// As the user has named it; empty while it goes by what it shows.
  [[nodiscard]] const QString& name() const { return name_; }
  void setName(const QString& name) { name_ = name; }

  bool eventFilter(QObject* watched, QEvent* event) override;

 Q_SIGNALS:
  void currentChanged();
  void closeRequested(PlotView* view);

 private:
  PlotView& insert(int place);
  void tellOrder();
  void markCurrent();
  void align();

  std::shared_ptr<TimeLink> link_;
  QSplitter* rows_;
  std::vector<PlotView*> views_;  // from above
  PlotView* current_ = nullptr;
  QString name_;
};

}  // namespace tendon::gui
