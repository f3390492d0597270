#pragma once

#include <gcm_gui/plot/canvas/plot_axes.h>
#include <gcm_gui/plot/frame_governor.h>
#include <gcm_gui/plot/series/cursors.h>
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
class MarkFlags;
class MarkTrack;
class PlotOverlay;

/// One live plot. Its curves share a time axis, which several plots may have in common; each unit
/// has its own Y axis.
///
/// Draws itself at 60 Hz at most, and less often if drawing is slow (FrameGovernor); only while
/// visible, and only if something has moved. The curves keep all samples, whatever part is shown.
/// GUI thread.
class PlotView : public QwtPlot {
  Q_OBJECT

 public:
  /// With a time axis of its own.
  explicit PlotView(QWidget* parent = nullptr);
  /// Shares `time_axis`: a change applies to all plots that share it.
  explicit PlotView(std::shared_ptr<SharedTimeAxis> time_axis, QWidget* parent = nullptr);
  ~PlotView() override;

  /// Returns the existing curve if the path is already plotted. Feed it by Curve::append().
  Curve& addCurve(const CurveKey& key);
  void removeCurve(const QString& path);
  /// Redraws after a change of a curve's state.
  void curveStateChanged() { changed(); }
  /// Unique among all plots of this program.
  [[nodiscard]] std::uint64_t id() const { return id_; }
  /// Removes a curve with its samples, for adoptCurve() of another plot; nullptr if none.
  [[nodiscard]] std::unique_ptr<Curve> takeCurve(const QString& path);
  void adoptCurve(std::unique_ptr<Curve> curve);
  [[nodiscard]] Curve* curve(const QString& path) const { return curves_.find(path); }
  [[nodiscard]] const CurveSet& curves() const { return curves_; }

  /// The time span of a live plot.
  void setWindow(std::chrono::nanoseconds length);
  [[nodiscard]] const TimeWindow& window() const { return window_; }
  /// How a live plot moves.
  void setMotion(TimeWindow::Motion motion);
  /// True stops the view at the present moment; false makes the time live.
  void setPaused(bool paused);
  /// Makes the time live, and lets all axes follow the data.
  void goLive();
  /// The same, for all plots that share the time.
  void goLiveTogether();
  [[nodiscard]] bool isLive() const;
  /// The sources' present time in ns of their steady clock: see LiveClock.
  [[nodiscard]] std::int64_t now() const;

  // In pixels of the canvas. Each of these leaves the live view; goBack() undoes it.
  void zoomTime(double factor, double x);
  void zoomValues(double factor, double y);
  void panTime(double pixels);
  void panValues(double pixels);
  void zoomTo(const QRect& rect);
  /// Ends the present step of the history; see SharedTimeAxis::Gesture.
  void endRun();
  // See SharedTimeAxis.
  void goBack();
  void goForward();
  [[nodiscard]] bool hasFormerView() const;
  [[nodiscard]] bool hasLaterView() const;

  /// Places the cursor at the time of canvas column `x`, live or not.
  void placeCursor(Cursor cursor, double x);
  /// The cursor drawn within some pixels of `x`.
  [[nodiscard]] std::optional<Cursor> cursorAt(double x) const;
  /// Shows A and B in the middle of the view, or removes both.
  void showCursors(bool shown);
  [[nodiscard]] const Cursors& cursors() const { return cursors_; }

  /// The room that the labels need, and the minimum room to keep; the same for all plots of a page.
  /// See PlotAxes.
  [[nodiscard]] SideRoom sideRoom() const { return axes_.wantedRoom(); }
  /// Sets the plots above this one on the page. If one of them shows curves, its button makes all
  /// plots live.
  void setPlotsAbove(const std::vector<PlotView*>& plots);
  /// Marks the current one of several plots with a line at the left edge.
  void setMarkedCurrent(bool marked);
  void setSideRoom(const SideRoom& least) { axes_.setRoom(least); }

  /// Draws these marks, which must outlive the plot. Call marksChanged() when they change.
  void setMarks(const MarkTrack& marks);
  void marksChanged() { changed(); }
  void setMarksShown(bool shown);
  /// The marks at canvas column `x`, one per line.
  [[nodiscard]] QString marksAt(double x) const;

  void setFit(Fit fit);
  [[nodiscard]] Fit fit() const { return curves_.fit(); }
  /// Sets the scale of all value axes; see CurveSet::setScale(). Values of 0 or less on a
  /// logarithmic axis are drawn at its bottom, and a note says so.
  void setScale(ValueScale scale);
  [[nodiscard]] ValueScale scale() const { return curves_.scale(); }
  /// Changes the look of an existing curve and refits its axis.
  void setLook(const QString& path, const CurveLook& look);
  /// Sets the names of an existing curve's values; null for numbers.
  void setNames(const QString& path, const ValueNamesPointer& names);
  /// Asks the user for the look of a curve.
  void askForLook(const QString& path);
  /// Shows minimum, maximum, mean and more of each curve's visible part in the legend.
  void setStatistics(bool shown);
  [[nodiscard]] bool hasStatistics() const { return statistics_; }

  /// Makes the legend show the values at canvas column `x` instead of the present ones.
  void setHover(std::optional<int> x);
  [[nodiscard]] std::vector<SourceFigures> figures() const;
  [[nodiscard]] Legend& legendBox();
  [[nodiscard]] PlotOverlay& overlay() { return *overlay_; }
  /// Paints the background, because QwtPlot would use the palette, which the style sheet changes.
  void drawCanvas(QPainter* painter) override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 120}; }
  [[nodiscard]] QSize sizeHint() const override { return {640, 280}; }
  /// The timer calls this to redraw what has changed.
  void refresh();

 Q_SIGNALS:
  void liveChanged(bool live);
  void motionChanged();
  /// The user wants to hide or show the marks.
  void marksToggled();
  void sideRoomChanged();
  void cursorsChanged(bool shown);
  void curvesDropped(const QList<CurveKey>& keys);
  /// The user dragged these curves here from the plot with this id.
  void curvesMoved(const QList<CurveKey>& keys, quint64 from);
  void curveRemovalRequested(const QString& path);
  void remapRequested(const QString& path);
  /// The user wants the menu at this place of the canvas.
  void menuRequested(const QPoint& position);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void drawItems(QPainter* painter, const QRectF& canvas_rect,
                 const QwtScaleMap maps[QwtAxis::AxisPositions]) const override;

 private:
  void build();
  void refreshGuarded();
  void takeTheme();
  void startDrag(const QString& path);
  void noticeSamples();
  void noticeSideRoom();
  void noticeChange();
  void changed();
  void updateLegend();
  void updateLive();
  void describeMarks();
  void curvesChanged();
  void choose(UnitAxis& axis, const AxisRange& range) const;
  [[nodiscard]] double columns() const;
  [[nodiscard]] bool isFitted() const;
  [[nodiscard]] bool isFirst() const;
  [[nodiscard]] std::vector<SeenSlices> seenSlices() const;

  PlotAxes axes_;
  CurveSet curves_;
  std::shared_ptr<SharedTimeAxis> time_axis_;
  TimeWindow& window_;  // belongs to the shared time axis, like the cursors
  Cursors& cursors_;
  const std::uint64_t id_;
  std::uint64_t seen_revision_ = 0;
  TimeWindow drawn_window_;
  std::int64_t newest_ns_;
  std::optional<int> shown_hover_;
  SideRoom side_room_;
  std::vector<QPointer<const PlotView>> above_;
  bool is_marked_current_ = false;
  bool dirty_ = true;
  bool statistics_ = false;
  bool was_live_ = true;
  FrameGovernor governor_;
  int ticks_ = 0;
  QTimer timer_;
  CurveLayer* layer_ = nullptr;  // QwtPlot owns this and the items below
  QwtPlotGrid* grid_ = nullptr;
  MarkFlags* flags_ = nullptr;
  PlotOverlay* overlay_ = nullptr;
  LegendArea* legend_ = nullptr;
  QPushButton* live_pill_ = nullptr;
};

}  // namespace tendon::gui
