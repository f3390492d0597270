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
  /// Redraws after a change of a curve's state.
  void curveStateChanged() { changed(); }
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
  [[nodiscard]] const TimeWindow& window() const { return window_; }
  /// Sets how a live plot moves.
  void setMotion(TimeWindow::Motion motion);
  /// True stops the view at the present time; false makes the view live.
  void setPaused(bool paused);
  /// Makes the view live, and lets all axes follow the data.
  void goLive();
  /// Makes all plots with this time axis live, and lets all their axes follow the data.
  void goLiveTogether();
  [[nodiscard]] bool isLive() const;
  /// Returns the present time of the sources, in ns of their steady clock; see LiveClock.
  [[nodiscard]] std::int64_t now() const;

  // `x` and `y` are in pixels of the canvas. Each of these functions ends the live view; goBack()
  // restores it.
  void zoomTime(double factor, double x);
  void zoomValues(double factor, double y);
  void panTime(double pixels);
  void panValues(double pixels);
  void zoomTo(const QRect& rect);
  /// Ends the present step of the history, so that the next gesture begins a new step; see
  /// SharedTimeAxis::Gesture.
  void endRun();
  /// Moves the curves of a recording by `pixels`, to the right if they are above 0. The visible
  /// time does not change.
  void moveRecording(const QString& recording, double pixels);
  /// Sets the time that is added to the times of a recording. This is a step of the history if a
  /// curve of the recording is already shown.
  void setShift(const QString& recording, std::int64_t shift_ns);
  [[nodiscard]] std::int64_t shift(const QString& recording) const;
  enum class Edge { kLeft, kRight };
  /// Sets the shift so that a time of the recording is at an edge of the view. The time is on the
  /// plots' clock, without the recording's shift.
  void align(const QString& recording, std::int64_t time_ns, Edge edge);
  /// True if this plot, or another one with this time axis, shows a curve of the recording.
  [[nodiscard]] bool isOnPage(const QString& recording) const;
  /// The files of the recordings that this plot shows.
  [[nodiscard]] QStringList recordings() const;
  /// Returns the recording whose curve is nearest to this point of the canvas; empty if there is no
  /// visible recorded curve.
  [[nodiscard]] QString recordingAt(const QPointF& point) const;

  // For goBack() and goForward() see SharedTimeAxis.
  void goBack();
  void goForward();
  [[nodiscard]] bool hasFormerView() const;
  [[nodiscard]] bool hasLaterView() const;

  /// Places the cursor at the time of canvas column `x`, even in a live plot.
  void placeCursor(Cursor cursor, double x);
  /// Returns the cursor that is drawn within a few pixels of `x`.
  [[nodiscard]] std::optional<Cursor> cursorAt(double x) const;
  /// True places A and B in the middle of the view; false removes both.
  void showCursors(bool shown);
  [[nodiscard]] const Cursors& cursors() const { return cursors_; }

  /// Returns the width that the labels of this plot need.
  [[nodiscard]] SideRoom sideRoom() const { return axes_.wantedRoom(); }
  /// Sets the plots above this one on the page. If one of them shows curves, that plot has the
  /// button that makes all plots live.
  void setPlotsAbove(const std::vector<PlotView*>& plots);
  /// Marks this plot as the current one of several plots, by a line at its left edge.
  void setMarkedCurrent(bool marked);
  void setSideRoom(const SideRoom& least) { axes_.setRoom(least); }

  /// Draws these marks, which must outlive the plot. Call marksChanged() when the marks change.
  void setMarks(const MarkTrack& marks);
  void marksChanged() { changed(); }
  void setMarksShown(bool shown);
  /// Returns the texts of the marks at canvas column `x`, one per line.
  [[nodiscard]] QString marksAt(double x) const;

  void setFit(Fit fit);
  [[nodiscard]] Fit fit() const { return curves_.fit(); }
  /// Sets the scale of all value axes; see CurveSet::setScale(). On a logarithmic axis, values of 0
  /// or less are drawn at the bottom, and a note tells the user.
  void setScale(ValueScale scale);
  [[nodiscard]] ValueScale scale() const { return curves_.scale(); }
  /// Changes the look of an existing curve and refits its axis.
  void setLook(const QString& path, const CurveLook& look);
  /// Sets the names of an existing curve's values; null if the values are plain numbers.
  void setNames(const QString& path, const ValueNamesPointer& names);
  /// Opens an editor in which the user changes the look of a curve and, if it is recorded, its
  /// shift.
  void askForLook(const QString& path);
  /// Opens the editor for a curve of this recording. Returns false if the plot shows none.
  bool askForShift(const QString& recording);
  /// Shows statistics (minimum, maximum, mean, …) of the visible part of each curve in the legend.
  void setStatistics(bool shown);
  [[nodiscard]] bool hasStatistics() const { return statistics_; }

  /// If `x` is set, the legend shows the values at canvas column `x`; otherwise the present values.
  void setHover(std::optional<int> x);
  [[nodiscard]] std::vector<SourceFigures> figures() const;
  [[nodiscard]] Legend& legendBox();
  [[nodiscard]] PlotOverlay& overlay() { return *overlay_; }
  /// Paints the background here because QwtPlot would use the palette, which the style sheet has
  /// changed.
  void drawCanvas(QPainter* painter) override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 120}; }
  [[nodiscard]] QSize sizeHint() const override { return {640, 280}; }
  /// Redraws the changed parts; called by a timer.
  void refresh();

 Q_SIGNALS:
  void liveChanged(bool live);
  void motionChanged();
  /// The user wants to hide or show the marks.
  void marksToggled();
  void sideRoomChanged();
  void cursorsChanged(bool shown);
  void curvesDropped(const QList<CurveKey>& keys);
  /// Emitted when the user has moved a recording, with its new shift.
  void recordingMoved(const QString& recording, qint64 shift_ns);
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
  void takeShifts();
  void choose(UnitAxis& axis, const AxisRange& range) const;
  [[nodiscard]] double columns() const;
  [[nodiscard]] bool isFitted() const;
  [[nodiscard]] bool isFirst() const;
  [[nodiscard]] std::vector<SeenSlices> seenSlices() const;

  PlotAxes axes_;
  CurveSet curves_;
  std::shared_ptr<SharedTimeAxis> time_axis_;
  TimeWindow& window_;  // belongs to the shared time axis, as do the cursors
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
  CurveLayer* layer_ = nullptr;  // QwtPlot owns this item and the items below
  QwtPlotGrid* grid_ = nullptr;
  MarkFlags* flags_ = nullptr;
  PlotOverlay* overlay_ = nullptr;
  LegendArea* legend_ = nullptr;
  QPushButton* live_pill_ = nullptr;
};

}  // namespace tendon::gui
