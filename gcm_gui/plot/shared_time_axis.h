#pragma once

#include <gcm_gui/plot/series/cursors.h>
#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/series/live_clock.h>
#include <gcm_gui/plot/series/time_window.h>

#include <QString>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace tendon::gui {

/// The state that the plots of one page share: the visible time, the present time of the sources,
/// the shifts of recordings relative to this time, the cursors, the column under the mouse, and the
/// history of views.
///
/// A plot that changes something must call touch(). The other plots compare revision() to notice
/// the change. GUI thread.
class SharedTimeAxis {
 public:
  /// The maximum number of steps in the history.
  static constexpr std::size_t kMaxSteps = 64;

  enum class Gesture {
    kOnce,      ///< always a separate step in the history
    kZoomTime,  ///< repeated gestures of this kind form one step, until another gesture or endRun()
    kZoomValues,
    kMove,
    kShift,
  };

  /// Adds the curves' axes to the states in the history, until leave().
  void join(CurveSet& curves);
  void leave(CurveSet& curves);
  /// Lets all axes follow the data.
  void fitAll();

  [[nodiscard]] TimeWindow& window() { return window_; }
  [[nodiscard]] Cursors& cursors() { return cursors_; }
  [[nodiscard]] LiveClock& clock() { return clock_; }
  /// Returns the present time of the sources, in ns of their steady clock; see LiveClock.
  [[nodiscard]] std::int64_t now() const;
  /// Moves a live window to the present time; see TimeWindow::follow().
  void follow(double columns) { window_.follow(now(), columns); }
  [[nodiscard]] std::optional<int> hover() const { return hover_; }
  /// Sets the column under the mouse. Returns true if it has changed.
  bool setHover(std::optional<int> column);

  /// The time that is added to the times of a recording; no value if no time was set. All curves of
  /// a recording have the same shift.
  [[nodiscard]] std::optional<std::int64_t> shift(const QString& recording) const;
  /// True if one of the plots shows a curve of this recording.
  [[nodiscard]] bool isShown(const QString& recording) const;
  /// Sets this time, limited to kLongestShift in both directions.
  void setShift(const QString& recording, std::int64_t shift_ns);

  void touch() { ++revision_; }
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

  /// Adds the present view to the history. Call it before `gesture` changes the view.
  void remember(Gesture gesture);
  void endRun() { last_gesture_ = Gesture::kOnce; }
  // goBack() and goForward() do nothing if the history has no further step.
  void goBack() { go(former_, later_); }
  void goForward() { go(later_, former_); }
  [[nodiscard]] bool hasFormer() const { return !former_.empty(); }
  [[nodiscard]] bool hasLater() const { return !later_.empty(); }

 private:
  struct ViewState {
    TimeWindow window;
    std::map<QString, std::int64_t> shifts;
    std::vector<std::pair<CurveSet*, std::vector<UnitAxis>>> axes;
  };

  [[nodiscard]] ViewState present() const;
  void go(std::vector<ViewState>& from, std::vector<ViewState>& to);

  TimeWindow window_;
  Cursors cursors_;
  LiveClock clock_;
  std::map<QString, std::int64_t> shifts_;  // by the file of the recording
  std::optional<int> hover_;
  std::vector<CurveSet*> sets_;
  std::vector<ViewState> former_;
  std::vector<ViewState> later_;
  Gesture last_gesture_ = Gesture::kOnce;
  std::uint64_t revision_ = 0;
};

}  // namespace tendon::gui
