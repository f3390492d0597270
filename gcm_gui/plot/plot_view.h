#pragma once

#include <gcm_gui/plot/frame_governor.h>
#include <gcm_gui/plot/plot_axes.h>
#include <gcm_gui/plot/series/cursors.h>
#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/series/live_clock.h>
#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/plot/series/time_window.h>
#include <qwt_plot.h>

#include <QTimer>
#include <chrono>
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

/// One live plot. Its curves share the time axis; each unit has a Y axis.
///
/// Draws itself at 60 Hz at most, at less where that is dear (FrameGovernor): only while it is
/// visible, and only when something has moved. The
/// samples are the curves' own, whatever is shown of them. GUI thread.
class PlotView : public QwtPlot {
  Q_OBJECT

 public:
  explicit PlotView(QWidget* parent = nullptr);

  /// The one there is, when the path is plotted already. Feed it by Curve::append().
  Curve& addCurve(const CurveKey& key);
  void removeCurve(const QString& path);
  [[nodiscard]] Curve* curve(const QString& path) const { return curves_.find(path); }
  [[nodiscard]] const CurveSet& curves() const { return curves_; }

  /// How long a live plot looks back.
  void setWindow(std::chrono::nanoseconds length);
  [[nodiscard]] const TimeWindow& window() const { return window_; }
  /// Shows what there was at that moment; false is live in time.
  void setPaused(bool paused);
  /// Live in time, and all axes follow the data.
  void goLive();
  [[nodiscard]] bool isLive() const;
  /// The sources' present time, in ns of their steady clock: see LiveClock.
  [[nodiscard]] std::int64_t now() const;

  // In pixels of the canvas. All but goBack() leave the live view.
  void zoomTime(double factor, double x);
  void zoomValues(double factor, double y);
  void panTime(double pixels);
  void panValues(double pixels);
  void zoomTo(const QRect& rect);
  /// For goBack(), which returns to what was shown when it was called last.
  void remember();
  void goBack();

  /// Marks the moment at canvas column `x`, live or not.
  void placeCursor(Cursor cursor, double x);
  /// The one that is drawn at `x`, give or take some pixels.
  [[nodiscard]] std::optional<Cursor> cursorAt(double x) const;
  /// A and B in the middle of what is seen, or neither.
  void showCursors(bool shown);
  [[nodiscard]] const Cursors& cursors() const { return cursors_; }

  /// Draws these, which must outlive the plot; marksChanged() when there are more.
  void setMarks(const MarkTrack& marks);
  void marksChanged() { changed(); }
  /// What is marked at canvas column `x`, a line each.
  [[nodiscard]] QString marksAt(double x) const;

  void setFit(Fit fit);
  [[nodiscard]] Fit fit() const { return curves_.fit(); }
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
  void cursorsChanged(bool shown);
  void curvesDropped(const QList<CurveKey>& keys);
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

 private:
  struct View {
    TimeWindow window;
    std::vector<UnitAxis> axes;
  };

  void build();
  void takeTheme();
  void noticeSamples();
  void changed();
  void updateLegend();
  void updateLive();
  void curvesChanged();
  [[nodiscard]] double columns() const;
  [[nodiscard]] QString figuresOf(const Curve& curve) const;

  PlotAxes axes_;
  CurveSet curves_;
  TimeWindow window_;
  Cursors cursors_;
  LiveClock clock_;
  std::vector<View> former_views_;
  std::int64_t newest_ns_;
  std::optional<int> hover_;
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
