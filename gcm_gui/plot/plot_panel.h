#pragma once

#include <gcm_gui/plot/csv/csv_export.h>
#include <gcm_gui/plot/marks/mark_track.h>
#include <gcm_gui/plot/row_losses.h>
#include <gcm_gui/plot/series/sample_ring.h>
#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/plot/series/value_names.h>

#include <QTimer>
#include <QWidget>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

class QStackedWidget;

namespace tendon::gui {

class FileReader;
class PlotHead;
class PlotPage;
class PlotView;

/// The plots of the window: pages of them, each a tab, in which plots lie below each other and show
/// the same time. They are counted from the first page's topmost.
///
/// The owner hears subscriptionWanted() and subscriptionReleased(), and brings what it gets by
/// append(). A path may be in several plots; it is wanted once. GUI thread.
class PlotPanel : public QWidget {
  Q_OBJECT

 public:
  static constexpr std::size_t kDefaultMemory = 200'000'000;

  explicit PlotPanel(QWidget* parent = nullptr);

  /// To the plot in front; nothing happens when it is there already.
  void addSignal(const QString& path, const QString& unit);
  /// From all plots.
  void removeSignal(const QString& path);
  /// Of paths in no plot nothing is kept.
  void append(const QString& path, std::span<const Sample> samples);
  /// The values of a signal have these names; null for numbers. In all plots, and in those that
  /// come to show it.
  void setNames(const QString& path, const ValueNamesPointer& names);
  /// The source was restarted: its ticks begin anew.
  void beginEpoch(const QString& path);
  /// Nothing comes until append() is called again; an empty `reason` says whose rows are waited
  /// for.
  void setStale(const QString& path, const QString& reason = {});
  [[nodiscard]] QStringList paths() const;
  /// In all plots.
  void addMark(Mark mark);
  [[nodiscard]] const MarkTrack& marks() const { return marks_; }
  /// In all plots. Marks that come while they are hidden are there afterwards.
  void setMarksShown(bool shown);
  [[nodiscard]] bool areMarksShown() const { return marks_shown_; }

  /// Stops the views; samples go on being kept.
  void setPaused(bool paused);
  [[nodiscard]] bool isPaused() const { return paused_; }
  /// Of the plot in front.
  void setWindow(std::chrono::nanoseconds length);
  /// Asks for a file, and saves there what the plot in front shows at the moment of asking: every
  /// sample in sight. Writing goes on beside the window.
  void askForCsv();
  /// The same for a picture of it, PNG or SVG.
  void askForPicture();
  /// For a file that holds which signals are in which plot; see LayoutOf().
  void askToSaveLayout();
  void askForLayout();
  /// Replaces the plots by those of `file` once it is read; what is wrong with it comes as a
  /// notice.
  void openLayout(const QString& file);
  void saveLayout(const QString& file);
  /// Shows `to` wherever `from` is shown.
  void remap(const QString& from, const CurveKey& to);
  /// What could be shown in place of a signal, the likeliest first.
  void setCandidates(std::function<QList<CurveKey>(const QString& path)> candidates);
  /// Where rows of a signal were lost.
  void setLosses(std::function<RowLosses(const QString& path)> losses);
  /// Why what a signal shows is old, and how old; empty where it is not. `newest_ns` is the time of
  /// its newest sample. See Curve::setStandstill(); asked a few times a second.
  using Standstills =
      std::function<QString(const QString& path, std::optional<std::int64_t> newest_ns)>;
  void setStandstills(Standstills standstills);
  void toggleCursors();

  /// For the samples of all plots, in bytes.
  void setMemoryBudget(std::size_t bytes);

  /// An empty plot on a page of its own, in front.
  PlotView& addPlot();
  /// An empty plot below the current one, with the same time.
  PlotView& splitPlot();
  /// The last one is emptied instead.
  void closePlot(int index);
  void closePlot(PlotView& view);
  [[nodiscard]] PlotView& currentPlot() const;
  [[nodiscard]] PlotView& plot(int index) const;
  [[nodiscard]] int plotCount() const;
  [[nodiscard]] int currentIndex() const;
  void showPlot(int index);
  /// Whether it shares its page with the plot before it.
  [[nodiscard]] bool isBelow(int index) const;
  /// Asks for a name of the page in front.
  void askForName();
  /// Of the page that the plot is on; empty: it goes by what it shows.
  void setName(PlotView& view, const QString& name);
  [[nodiscard]] QString name(int index) const;

 Q_SIGNALS:
  void subscriptionWanted(const QString& path);
  void subscriptionReleased(const QString& path);
  void pausedChanged(bool paused);
  void marksShownChanged(bool shown);
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  void buildTabs();
  void connectHead();
  void prepare(PlotView& view);
  void closePage(int index);
  void showPage(int index);
  void move(const QString& path, quint64 from, PlotView& to);
  [[nodiscard]] PlotPage& page(int index) const;
  [[nodiscard]] PlotPage& pageOf(const PlotView& view) const;
  [[nodiscard]] std::vector<PlotView*> plots() const;
  void add(PlotView& view, const CurveKey& key);
  void removeFrom(PlotView& view, const QString& path);
  void showTabMenu(const QPoint& position);
  void showPlotMenu(PlotView& view, const QPoint& position);
  void askForRemap(const QString& path);
  using FileHandler = std::function<void(const QString& file)>;
  void askForFile(const QString& title, const QString& filter, const QString& suffix,
                  FileHandler handler);
  void nameTab(PlotView& view);
  void updateHead();
  void updateStandstills();
  void shareMemory();
  [[nodiscard]] bool isPlotted(const QString& path) const;
  [[nodiscard]] ValueNamesPointer namesOf(const QString& path) const;

  CsvExport csv_;
  FileReader* reader_;
  MarkTrack marks_;
  PlotHead* head_;
  QStackedWidget* pages_;
  std::function<QList<CurveKey>(const QString& path)> candidates_;
  std::function<RowLosses(const QString& path)> losses_;
  Standstills standstills_;
  QTimer head_timer_;
  std::size_t memory_ = kDefaultMemory;
  bool paused_ = false;
  bool marks_shown_ = true;
};

}  // namespace tendon::gui
