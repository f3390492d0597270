#pragma once

#include <gcm_gui/plot/canvas/plot_axes.h>
#include <gcm_gui/plot/frame_governor.h>
#include <gcm_gui/plot/plot_cursors.h>
#include <gcm_gui/plot/plot_gestures.h>
#include <gcm_gui/plot/plot_marks.h>
#include <gcm_gui/plot/recorded_curves.h>
#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/plot/series/time_window.h>
#include <gcm_gui/plot/shared_time_axis.h>
#include <qwt_axis.h>
#include <qwt_plot.h>

#include <QPointer>
#include <QTimer>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

class QPushButton;
class QwtPlotGrid;

namespace tendon::gui {

class CurveLayer;
class Legend;
class LegendArea;
class PlotOverlay;

/// One live plot. All its curves have the same time axis, which may be shared with other plots.
/// Each unit has its own Y axis.
///
/// Redraws itself at most at 60 Hz, and less often if drawing is slow (FrameGovernor). It redraws
/// only while it is visible, and only if something has changed. The curves keep all samples,
/// including samples outside of the shown part. GUI thread.
class PlotView : public QwtPlot {
  Q_OBJECT

 public:
  /// Creates a plot with its own time axis.
  explicit PlotView(QWidget* parent = nullptr);
  /// Creates a plot with a shared time axis. A change of the axis applies to all plots that share
  /// it.
  explicit PlotView(std::shared_ptr<SharedTimeAxis> time_axis, QWidget* parent = nullptr);
  ~PlotView() override;

  /// Adds a curve, or returns the existing curve if the path is already plotted. Pass samples to
  /// Curve::append().
  Curve& addCurve(const CurveKey& key);
  void removeCurve(const QString& path);
  /// Redraws after a change of a curve's state or of the marks.
  void requestRedraw();
  /// Unique among all plots of this program.
  [[nodiscard]] std::uint64_t id() const { return id_; }
  /// Removes a curve with its samples and returns it, so that another plot can adoptCurve() it;
  /// nullptr if the path is not plotted.
  [[nodiscard]] std::unique_ptr<Curve> takeCurve(const QString& path);
  void adoptCurve(std::unique_ptr<Curve> curve);
  [[nodiscard]] Curve* curve(const QString& path) const { return curves_.find(path); }
  [[nodiscard]] const CurveSet& curves() const { return curves_; }

  /// Sets the time span of a live plot.
  void setWindow(std::chrono::nanoseconds length);
  [[nodiscard]] const TimeWindow& timeWindow() const { return window_; }
  /// Sets how a live plot moves.
  void setMotion(TimeWindow::Motion motion);
  /// True stops the view at the present time; false makes the view live.
  void setPaused(bool paused);
  [[nodiscard]] bool isLive() const { return window_.isLive(); }
  /// Returns the present time of the sources, in ns of their steady clock; see LiveClock.
  [[nodiscard]] std::int64_t now() const { return time_axis_->now(); }

  [[nodiscard]] PlotGestures& gestures() { return gestures_; }
  [[nodiscard]] RecordedCurves& recordedCurves() { return recorded_curves_; }
  [[nodiscard]] PlotCursors& cursors() { return cursors_; }
  [[nodiscard]] PlotMarks& marks() { return marks_; }
  [[nodiscard]] PlotAxes& axes() { return axes_; }

  /// Sets the plots above this one on the page. If one of them shows curves, that plot has the
  /// button that makes all plots live.
  void setPlotsAbove(const std::vector<PlotView*>& plots);
  /// Marks this plot as the current one of several plots, by a line at its left edge.
  void setMarkedCurrent(bool marked);

  void setFit(Fit fit);
  /// Sets the scale of all value axes; see CurveSet::setScale(). On a logarithmic axis, values of 0
  /// or less are drawn at the bottom, and a note tells the user.
  void setScale(ValueScale scale);
  /// Changes the look of an existing curve and refits its axis.
  void setLook(const QString& path, const CurveLook& look);
  /// Sets the names of an existing curve's values; null if the values are plain numbers.
  void setNames(const QString& path, const ValueNamesPointer& names);
  /// Shows statistics (minimum, maximum, mean, …) of the visible part of each curve in the legend.
  void setStatistics(bool shown);
  [[nodiscard]] bool hasStatistics() const { return statistics_; }

  /// If `x` is set, the legend shows the values at canvas column `x`; otherwise the present values.
  void setHover(std::optional<int> x);
  [[nodiscard]] Legend& legendBox();
  [[nodiscard]] PlotOverlay& overlay() { return *overlay_; }
  /// Redraws the changed parts; called by a timer.
  void refresh();

 Q_SIGNALS:
  void liveChanged(bool live);
  void motionChanged();
  /// The user wants to hide or show the marks.
  void marksToggled();
  void sideRoomChanged();
  void curvesDropped(const QList<CurveKey>& keys);
  /// Emitted when the user has dragged these curves here from the plot with the id `from`.
  void curvesMoved(const QList<CurveKey>& keys, quint64 from);
  void curveRemovalRequested(const QString& path);
  void remapRequested(const QString& path);
  /// Emitted when the user wants the context menu at this position of the canvas.
  void menuRequested(const QPoint& position);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 120}; }
  [[nodiscard]] QSize sizeHint() const override { return {640, 280}; }
  /// Paints the background here because QwtPlot would use the palette, which the style sheet has
  /// changed.
  void drawCanvas(QPainter* painter) override;
  void drawItems(QPainter* painter, const QRectF& canvas_rect,
                 const QwtScaleMap maps[QwtAxis::AxisPositions]) const override;

 private:
  void build();
  void refreshGuarded();
  void takeTheme();
  /// Opens an editor in which the user changes the look of a curve and, if it is recorded, its
  /// shift.
  void askForLook(const QString& path);
  void startDrag(const QString& path);
  void noticeSamples();
  void noticeSideRoom();
  void noticeChange();
  void updateLegend();
  void updateLive();
  void curvesChanged();
  [[nodiscard]] bool isFirst() const;
  [[nodiscard]] std::vector<VisibleSlices> visibleSlices() const;

  PlotAxes axes_;
  CurveSet curves_;
  std::shared_ptr<SharedTimeAxis> time_axis_;
  TimeWindow& window_;  // belongs to the shared time axis
  PlotGestures gestures_;
  RecordedCurves recorded_curves_;
  PlotCursors cursors_;
  PlotMarks marks_;
  const std::uint64_t id_;
  std::uint64_t seen_revision_ = 0;
  TimeWindow drawn_window_;
  std::int64_t newest_ns_;
  std::optional<int> shown_hover_;
  AxisMargins side_room_;
  std::vector<QPointer<const PlotView>> above_;
  bool is_marked_current_ = false;
  bool dirty_ = true;
  bool statistics_ = false;
  bool was_live_ = true;
  FrameGovernor governor_;
  int ticks_ = 0;
  QTimer timer_;
  CurveLayer* layer_ = nullptr;  // QwtPlot owns this item and the items below
  QwtPlotGrid* grid_ = nullptr;
  PlotOverlay* overlay_ = nullptr;
  LegendArea* legend_ = nullptr;
  QPushButton* live_pill_ = nullptr;
};

}  // namespace tendon::gui
