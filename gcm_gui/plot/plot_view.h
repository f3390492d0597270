#pragma once

#include <gcm_gui/plot/axes/plot_axes.h>
#include <gcm_gui/plot/frame_governor.h>
#include <gcm_gui/plot/link/time_link.h>
#include <gcm_gui/plot/series/cursors.h>
#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/plot/series/time_window.h>
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

/// One live plot. Its curves share the time axis, which it may have in common with other plots;
/// each unit has a Y axis.
///
/// Draws itself at 60 Hz at most, at less where that is dear (FrameGovernor): only while it is
/// visible, and only when something has moved. The
/// samples are the curves' own, whatever is shown of them. GUI thread.
class PlotView : public QwtPlot {
  Q_OBJECT

 public:
  /// Its time is its own.
  explicit PlotView(QWidget* parent = nullptr);
  /// Shows the time of `link`, and what is done to its time is done to all that share it.
  explicit PlotView(std::shared_ptr<TimeLink> link, QWidget* parent = nullptr);
  ~PlotView() override;

  /// The one there is, when the path is plotted already. Feed it by Curve::append().
  Curve& addCurve(const CurveKey& key);
  void removeCurve(const QString& path);
  /// Draws anew what was said to a curve.
  void curveStateChanged() { changed(); }
  /// Of all plots of this program only this one has it.
  [[nodiscard]] std::uint64_t id() const { return id_; }
  /// With its samples, for adoptCurve() of another plot; nullptr when there is none.
  [[nodiscard]] std::unique_ptr<Curve> takeCurve(const QString& path);
  void adoptCurve(std::unique_ptr<Curve> curve);
  [[nodiscard]] Curve* curve(const QString& path) const { return curves_.find(path); }
  [[nodiscard]] const CurveSet& curves() const { return curves_; }

  /// How long a live plot looks back.
  void setWindow(std::chrono::nanoseconds length);
  [[nodiscard]] const TimeWindow& window() const { return window_; }
  /// How a live plot goes on.
  void setMotion(TimeWindow::Motion motion);
  /// Shows what there was at that moment; false is live in time.
  void setPaused(bool paused);
  /// Live in time, and all axes follow the data.
  void goLive();
  /// And so do those of all plots that share the time.
  void goLiveTogether();
  [[nodiscard]] bool isLive() const;
  /// The sources' present time, in ns of their steady clock: see LiveClock.
  [[nodiscard]] std::int64_t now() const;

  // In pixels of the canvas. All leave the live view, and goBack() undoes them.
  void zoomTime(double factor, double x);
  void zoomValues(double factor, double y);
  void panTime(double pixels);
  void panValues(double pixels);
  void zoomTo(const QRect& rect);
  /// What follows is another step than what was done before; see TimeLink::Gesture.
  void endRun();
  // See TimeLink.
  void goBack();
  void goForward();
  [[nodiscard]] bool hasFormerView() const;
  [[nodiscard]] bool hasLaterView() const;

  /// Marks the moment at canvas column `x`, live or not.
  void placeCursor(Cursor cursor, double x);
  /// The one that is drawn at `x`, give or take some pixels.
  [[nodiscard]] std::optional<Cursor> cursorAt(double x) const;
  /// A and B in the middle of what is seen, or neither.
  void showCursors(bool shown);
  [[nodiscard]] const Cursors& cursors() const { return cursors_; }

  /// What labels beside the canvas take, and how much is to be kept free for them: plots below each
  /// other have the same; see PlotAxes.
  [[nodiscard]] SideRoom sideRoom() const { return axes_.wantedRoom(); }
  /// With the same time: where one of them shows curves, all are told there to go live.
  void setPlotsAbove(const std::vector<PlotView*>& plots);
  /// A stroke at its left edge says that it is the one among several that commands go to.
  void setMarkedCurrent(bool marked);
  void setSideRoom(const SideRoom& least) { axes_.setRoom(least); }

  /// Draws these, which must outlive the plot; marksChanged() when there are more.
  void setMarks(const MarkTrack& marks);
  void marksChanged() { changed(); }
  void setMarksShown(bool shown);
  /// What is marked at canvas column `x`, a line each.
  [[nodiscard]] QString marksAt(double x) const;

  void setFit(Fit fit);
  [[nodiscard]] Fit fit() const { return curves_.fit(); }
  /// Of the values of all curves; see CurveSet::setScale(). What has no place on a logarithmic axis
  /// is drawn at its foot, and said.
  void setScale(ValueScale scale);
  [[nodiscard]] ValueScale scale() const { return curves_.scale(); }
  /// What is shown of a curve that is there; its axis is fitted anew.
  void setLook(const QString& path, const CurveLook& look);
  /// The names of its values, of a curve that is there; null for numbers.
  void setNames(const QString& path, const ValueNamesPointer& names);
  /// Asks the user for it.
  void askForLook(const QString& path);
  /// The legend tells lowest, highest, mean and more of what is seen of each curve.
  void setStatistics(bool shown);
  [[nodiscard]] bool hasStatistics() const { return statistics_; }

  /// The legend shows the values at canvas column `x` instead of the present ones.
  void setHover(std::optional<int> x);
  [[nodiscard]] std::vector<SourceFigures> figures() const;
  [[nodiscard]] Legend& legendBox();
  [[nodiscard]] PlotOverlay& overlay() { return *overlay_; }
  /// QwtPlot would leave the background to the palette, which the style sheet meddles with.
  void drawCanvas(QPainter* painter) override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 120}; }
  [[nodiscard]] QSize sizeHint() const override { return {640, 280}; }
  /// What the timer does: draws anew what has changed.
  void refresh();

 Q_SIGNALS:
  void liveChanged(bool live);
  void motionChanged();
  /// Marks are to be hidden, or shown again.
  void marksToggled();
  void sideRoomChanged();
  void cursorsChanged(bool shown);
  void curvesDropped(const QList<CurveKey>& keys);
  /// They were dragged here from the plot with this id.
  void curvesMoved(const QList<CurveKey>& keys, quint64 from);
  void curveRemovalRequested(const QString& path);
  void remapRequested(const QString& path);
  /// At a place of the canvas.
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
  void refreshFenced();
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
  std::shared_ptr<TimeLink> link_;
  TimeWindow& window_;  // of the link, as are the cursors
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
  CurveLayer* layer_ = nullptr;  // owned by QwtPlot, as are the items below
  QwtPlotGrid* grid_ = nullptr;
  MarkFlags* flags_ = nullptr;
  PlotOverlay* overlay_ = nullptr;
  LegendArea* legend_ = nullptr;
  QPushButton* live_pill_ = nullptr;
};

}  // namespace tendon::gui
