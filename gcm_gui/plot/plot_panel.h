#pragma once

#include <gcm_gui/plot/plot_tabs.h>
#include <gcm_gui/plot/series/mark_track.h>
#include <gcm_gui/plot/series/row_losses.h>
#include <gcm_gui/plot/series/sample_ring.h>
#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/plot/series/time_window.h>
#include <gcm_gui/plot/series/value_names.h>

#include <QTimer>
#include <QWidget>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

class QStackedWidget;

namespace tendon::gui {

class PlotFiles;
class PlotHeader;
class PlotView;

/// The plots of the window. Each page has a tab and contains plots below each other that show the
/// same time. The index of a plot counts from the top of the first page.
///
/// The owner must subscribe to a path on subscriptionWanted(), unsubscribe on
/// subscriptionReleased(), and pass samples to append(). A path in several plots is subscribed only
/// once. GUI thread.
class PlotPanel : public QWidget {
  Q_OBJECT

 public:
  static constexpr std::size_t kDefaultMemory = 200'000'000;

  /// `memory` in bytes is for the samples of all plots together.
  explicit PlotPanel(QWidget* parent = nullptr, std::size_t memory = kDefaultMemory);

  // Signals and their samples.

  /// Adds the signal to the current plot. Does nothing if the plot already has it.
  void addSignal(const QString& path, const QString& unit);
  /// Appends samples to all curves of the path. Ignored if no plot has this path.
  void append(const QString& path, std::span<const Sample> samples);
  /// Sets the names of a signal's values in all present and future plots; null if the values are
  /// plain numbers.
  void setNames(const QString& path, const ValueNamesPointer& names);
  /// Called when the source was restarted, so that its ticks start again.
  void beginEpoch(const QString& path);
  /// Called when no samples will arrive until the next append(). With an empty `reason`, the curve
  /// shows the name of the source for which it waits.
  void setStale(const QString& path, const QString& reason = {});
  /// The signals of the shown system that are plotted.
  [[nodiscard]] QStringList paths() const;
  /// Clears all curves of the shown system or of a recording, because samples of another time
  /// follow.
  void removeSamples(const QString& recording = {});
  /// Replaces the signal `from` by the signal `to` in all plots.
  void remap(const QString& from, const CurveKey& to);
  /// Sets the function that suggests replacements for a signal, the most likely first.
  void setCandidates(std::function<QList<CurveKey>(const QString& path)> candidates);
  /// Sets the function that returns where rows of a signal were lost.
  void setLosses(std::function<RowLosses(const QString& path)> losses);
  /// Returns a text with the reason why a signal is old and the time since then; empty if the
  /// signal is not old. `newest_ns` is the time of its newest sample. This function is called a few
  /// times per second; the result is passed to Curve::setStandstill().
  using Standstills =
      std::function<QString(const QString& path, std::optional<std::int64_t> newest_ns)>;
  void setStandstills(Standstills standstills);

  // Recordings.

  /// Sets the time span of a recording, in ns of the plots' clock without the recording's shift.
  /// Its curves have no values outside of this span.
  void setRecordedTime(const QString& recording, const TimeSpan& time);
  /// Shifts a recording so that its beginning is at the left edge of the plot. The time of the
  /// recording must be known.
  void showBegin(PlotView& view, const QString& recording);
  /// Returns the part of a recording that the current page shows, in ns of the plots' clock without
  /// the recording's shift; returns nothing if the page shows no curve of this recording.
  [[nodiscard]] std::optional<TimeSpan> seenOf(const QString& recording) const;

  // Plots and pages.

  /// Adds an empty plot on a new page and makes it current.
  PlotView& addPlot();
  /// Adds an empty plot below the current one, with the same time.
  PlotView& splitPlot();
  /// Closes a plot. If it is the only one, removes its curves instead.
  void closePlot(int index);
  void closePlot(PlotView& view);
  [[nodiscard]] PlotView& currentPlot() const;
  [[nodiscard]] PlotView& plot(int index) const;
  [[nodiscard]] int plotCount() const;
  [[nodiscard]] int currentIndex() const;
  void showPlot(int index);
  /// True if the plot is on the same page as the plot before it.
  [[nodiscard]] bool isBelow(int index) const;
  /// Asks for a name for the current page.
  void askForName();
  /// Adds a mark to all plots.
  void addMark(Mark mark);
  void removeMarks();
  [[nodiscard]] const MarkTrack& marks() const { return marks_; }
  /// Shows or hides the marks in all plots. Marks that are added while hidden are stored.
  void setMarksShown(bool shown);
  [[nodiscard]] bool areMarksShown() const { return marks_shown_; }

  /// True stops all plots at the present time; false makes them live. Samples are stored meanwhile.
  void setPaused(bool paused);
  [[nodiscard]] bool isPaused() const { return paused_; }
  /// Sets the time span of the current plot.
  void setWindow(std::chrono::nanoseconds length);
  void toggleCursors();
  /// The names of the plots and their tabs.
  [[nodiscard]] PlotTabs& tabs() { return tabs_; }
  [[nodiscard]] const PlotTabs& tabs() const { return tabs_; }
  [[nodiscard]] PlotFiles& files() const { return *files_; }

 Q_SIGNALS:
  void subscriptionWanted(const QString& path);
  void subscriptionReleased(const QString& path);
  /// The user wants to add curves of a recording to the current plot.
  void recordingRequested();
  void pausedChanged(bool paused);
  void marksShownChanged(bool shown);
  /// Emitted with one sentence for the user.
  void notice(const QString& text);

 private:
  void buildTabs();
  void connectHead();
  void prepare(PlotView& view);
  void closePage(int index);
  void showPage(int index);
  void move(const QString& path, quint64 from, PlotView& to);
  void add(PlotView& view, const CurveKey& key);
  void removeFrom(PlotView& view, const QString& path);
  void showTabMenu(const QPoint& position);
  void showPlotMenu(PlotView& view, const QPoint& position);
  void askForRemap(const QString& path);
  void updateHead();
  void updateStandstills();
  void shareMemory();
  [[nodiscard]] bool isPlotted(const QString& path) const;
  [[nodiscard]] ValueNamesPointer namesOf(const QString& path) const;

  std::map<QString, TimeSpan> recorded_times_;  // by the file of the recording
  MarkTrack marks_;
  PlotHeader* head_;
  QStackedWidget* pages_;
  PlotTabs tabs_;
  PlotFiles* files_;
  std::function<QList<CurveKey>(const QString& path)> candidates_;
  std::function<RowLosses(const QString& path)> losses_;
  Standstills standstills_;
  QTimer head_timer_;
  const std::size_t memory_;  // bytes
  bool paused_ = false;
  bool marks_shown_ = true;
};

}  // namespace tendon::gui
